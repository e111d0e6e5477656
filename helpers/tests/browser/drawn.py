"""What a view's page shows at a moment, as a number."""

STILL = 10  # pictures that are alike
# A number that differs when names are drawn elsewhere, as when a frame has moved or one looks from elsewhere; it is
# taken when a few pictures in a row are alike.
DRAWN = """() => new Promise((done) => {
    const canvas = document.getElementById('labels');
    let last = null, alike = 0;
    const look = () => {
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let sum = 0;
        for (let i = 3; i < data.length; i += 4) sum = (31 * sum + data[i]) % 1000003;
        alike = sum === last ? alike + 1 : 0;
        last = sum;
        if (alike < STILL) requestAnimationFrame(look); else done(sum);
    };
    look();
})""".replace('STILL', str(STILL))
