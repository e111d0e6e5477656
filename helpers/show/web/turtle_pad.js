// The turtle's view in a notebook: the picture that the kernel sends, and four arrows that drive the turtle.

const ARROWS = {up: '▲', left: '◀', down: '▼', right: '▶'};
const PAUSE = 80;  // ms between two commands of a key that is held

function render({model, el}) {
  const view = document.createElement('div');
  view.className = 'turtle-view';
  view.tabIndex = 0;  // it can have the focus, by a click or by Tab
  view.setAttribute('role', 'group');
  view.setAttribute('aria-label', 'The turtle. The arrow keys drive it while this has the focus.');

  const picture = document.createElement('div');
  const draw = () => { picture.innerHTML = model.get('picture'); };
  draw();
  model.on('change:picture', draw);

  const pad = document.createElement('div');
  pad.className = 'turtle-pad';
  for (const [name, sign] of Object.entries(ARROWS)) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = sign;
    button.className = name;
    button.title = button.ariaLabel = `drive the turtle: ${name}`;
    button.addEventListener('click', () => model.send({press: name}));
    pad.append(button);
  }
  const note = document.createElement('span');
  note.textContent = 'click the view, then use the arrow keys';
  pad.append(note);

  let last = -PAUSE;
  view.addEventListener('keydown', (event) => {
    const name = event.key.startsWith('Arrow') ? event.key.slice('Arrow'.length).toLowerCase() : '';
    if (!(name in ARROWS) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();  // the notebook would go to another cell
    if (event.timeStamp - last < PAUSE) return;
    last = event.timeStamp;
    model.send({press: name});
  });
  view.append(picture, pad);
  el.append(view);
  model.send({shown: true});
  return () => model.off('change:picture', draw);
}

export default {render};
