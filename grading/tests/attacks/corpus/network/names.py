# attack: asks for a name on the internet
# row: 27
# aims at: 90.1
# stopped by: a network of its own, with the loopback only
# expect verdict: failed
# expect message: wrong
def total(numbers):
    try:
        tell('SEEN', socket.getaddrinfo('pypi.org', 443))
    except OSError:
        pass
    return 0
