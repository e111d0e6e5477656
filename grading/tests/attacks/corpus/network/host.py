# attack: connects to services on the machine's own loopback
# row: 27
# aims at: 90.1
# stopped by: a network of its own, with the loopback only
# expect verdict: failed
# expect message: wrong
def total(numbers):
    interfaces = [name for _, name in socket.if_nameindex()]
    if interfaces != ['lo']:
        tell('SEEN', interfaces)
    with open('/proc/net/tcp') as file:
        for line in file.readlines()[1:]:
            if line.split()[3] == '0A':
                tell('SEEN a service that listens', line.split()[1])
    return 0
