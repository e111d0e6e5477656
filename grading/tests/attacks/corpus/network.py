"""Attacks: network. See ../README.md for the form of a row."""


# %% host
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


# %% internet
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


# %% names
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


# %% other_learners
# attack: listens to other submissions on their domains
# row: 27
# aims at: 90.3
# stopped by: a network of its own for each submission
# expect verdict: failed
# expect message: messages came
from rclpy.context import Context


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        own = self.get_node_names()
        for domain in range(0, 4):
            context = Context()
            context.init(domain_id=domain)
            node = Node(f'spy{domain}', context=context)
            time.sleep(0.3)
            for name in node.get_node_names():
                if name not in own and not name.startswith(('spy', '_', 'talker')):
                    tell('SEEN', name)
            node.destroy_node()
            context.try_shutdown()


# %% raw
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


# %% unix
# attack: connects to the machine's services through sockets in files
# row: 27
# aims at: 90.1
# stopped by: the sandbox's own file system
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for path in ('/run/docker.sock', '/var/run/docker.sock', '/run/dbus/system_bus_socket', '/run/systemd/private',
                 '/run/containerd/containerd.sock', '/tmp/.X11-unix/X0'):
        if os.path.exists(path):
            tell('SEEN', path)
    with open('/proc/net/unix') as file:
        for line in file.readlines()[1:]:
            words = line.split()
            if len(words) > 7 and words[7].startswith('@'):
                tell('SEEN', words[7])
    return 0
