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
