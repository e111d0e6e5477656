# attack: sends what it knows to the internet
# row: 27
# aims at: 90.1
# stopped by: a network of its own, with the loopback only
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for family, address in ((socket.AF_INET, ('1.1.1.1', 53)), (socket.AF_INET, ('169.254.169.254', 80)),
                            (socket.AF_INET6, ('2606:4700:4700::1111', 53))):
        try:
            with socket.socket(family, socket.SOCK_STREAM) as sock:
                sock.settimeout(0.5)
                sock.connect(address)
                tell('SEEN', address)
        except OSError as error:
            if 'timed out' in str(error):
                tell('SEEN a route to', address)
    return 0
