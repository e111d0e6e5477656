# attack: opens raw, packet and host sockets
# row: 27
# aims at: 90.1
# stopped by: no capability, and the system calls are not allowed
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for family, kind, protocol in ((socket.AF_INET, socket.SOCK_RAW, 1), (socket.AF_PACKET, socket.SOCK_RAW, 3),
                                   (40, socket.SOCK_STREAM, 0)):
        try:
            with socket.socket(family, kind, protocol):
                tell('SEEN socket', int(family))
        except OSError:
            pass
    return 0
