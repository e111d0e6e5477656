"""What a learner's program finds out about the place where it runs: `facts()`. This text is a notebook's cell."""

import ctypes
import json
import os
import resource
import socket
import sys


def attempt(act):
    """'' or what went wrong."""
    try:
        act()
    except OSError as error:
        return os.strerror(error.errno) if error.errno and error.errno > 0 else str(error)
    return ''


def write(path):
    def act():
        with open(path, 'w') as file:
            file.write('x')

    return attempt(act)


def system_call(*numbers):
    libc = ctypes.CDLL(None, use_errno=True)
    return '' if libc.syscall(*numbers) != -1 else os.strerror(ctypes.get_errno())


def filter_of_a_socket():
    """It lets all packets through."""
    one = ctypes.create_string_buffer(bytes([6, 0, 0, 0, 255, 255, 0, 0]))
    program = ctypes.c_uint64(1), ctypes.c_void_p(ctypes.addressof(one))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as owner:
        return attempt(lambda: owner.setsockopt(socket.SOL_SOCKET, 26, b''.join(map(bytes, program))))


def links(folder):
    found = {}
    for name in os.listdir(folder):
        try:
            found[name] = os.readlink(f'{folder}/{name}')
        except OSError:
            pass
    return found


def status():
    """Who the program is, and what it may."""
    with open('/proc/self/status') as file:
        found = dict(line.rstrip('\n').split(':\t', 1) for line in file if ':\t' in line)
    keys = ('Uid', 'Gid', 'CapInh', 'CapPrm', 'CapEff', 'CapBnd', 'CapAmb', 'NoNewPrivs', 'Seccomp')
    return {key: found[key] for key in keys}


def writes():
    """What goes wrong when it writes to these places."""
    places = (
        '/x',
        '/usr/x',
        '/etc/x',
        '/dev/x',
        '/home/x',
        os.path.join(sys.prefix, 'x'),
        json.__file__,
        '/proc/sys/kernel/core_pattern',
        '/proc/sys/kernel/ns_last_pid',
        '/tmp/x',
        '/dev/shm/x',
        os.path.expanduser('~/x'),
    )
    return {path: write(path) for path in places}


def network(port, name):
    """What goes wrong when it speaks to others; the host has a TCP port and an abstract Unix socket."""

    def unix():
        with socket.socket(socket.AF_UNIX) as client:
            client.connect('\0' + name)

    def datagram(family, address):
        with socket.socket(family, socket.SOCK_DGRAM) as client:
            client.sendto(b'x', address)

    return {
        'tcp to the host': attempt(lambda: socket.create_connection(('127.0.0.1', port), 2).close()),
        'abstract unix socket of the host': attempt(unix),
        'tcp': attempt(lambda: socket.create_connection(('192.0.2.1', 80), 2).close()),
        'udp': attempt(lambda: datagram(socket.AF_INET, ('192.0.2.1', 53))),
        'ipv6': attempt(lambda: datagram(socket.AF_INET6, ('2001:db8::1', 53))),
        'dns': attempt(lambda: socket.getaddrinfo('example.org', 80)),
        'vsock': attempt(lambda: socket.socket(40, socket.SOCK_STREAM).close()),
        'packets': attempt(lambda: socket.socket(17, socket.SOCK_RAW).close()),
        'raw': attempt(lambda: socket.socket(socket.AF_INET, socket.SOCK_RAW, 1).close()),
    }


def calls():
    """What goes wrong in system calls, by their numbers."""
    return {
        'unshare': system_call(272, 0x10000000),
        'clone': system_call(56, 0x10000011, 0, 0, 0, 0),
        'clone3': system_call(435, 0, 0),
        'ptrace': system_call(101, 0, 1, 0, 0),
        'keyctl': system_call(250, 0, 0),
        'bpf': system_call(321, 0, 0, 0),
        'x32': system_call(0x40000027),
        'mount': system_call(165, 0, 0, 0, 0, 0),
        'setns': system_call(308, 0, 0),
        'io_uring': system_call(425, 1, 0),
        'perf_event_open': system_call(298, 0, 0, -1, -1, 0),
        'userfaultfd': system_call(323, 1),
        'add_key': system_call(248, 0, 0, 0, 0, -3),
        'shmget': system_call(29, 0, 4096, 0o1600),
        'semget': system_call(64, 0, 1, 0o1600),
        'msgget': system_call(68, 0, 0o1600),
        'inotify_init': system_call(253),
        'inotify_init1': system_call(294, 0),
        'io_setup': system_call(206, 1, ctypes.byref(ctypes.c_long(0))),
        'landlock': system_call(444, 0, 0, 1),  # asks for its version
        'seccomp': system_call(317, 2, 0, ctypes.byref(ctypes.c_uint32(0x7FFF0000))),  # GET_ACTION_AVAIL
        'prctl: seccomp': system_call(157, 22, 0, 0, 0, 0),
        'vmsplice': system_call(278, os.pipe()[1], 0, 0, 0),
        'signals about a folder': system_call(72, os.open('/usr/lib', os.O_RDONLY), 1026, 0x80000001),
        'size of a pipe': system_call(72, os.pipe()[1], 1031, 2**16),
        'lock of an open file': system_call(72, os.open('/tmp', os.O_RDONLY), 37, bytes(32)),
        'filter of a socket': filter_of_a_socket(),
        'getpid': system_call(39),
    }


def limits():
    keys = ('RLIMIT_AS', 'RLIMIT_CPU', 'RLIMIT_NOFILE', 'RLIMIT_FSIZE', 'RLIMIT_CORE', 'RLIMIT_NPROC')
    return {key: resource.getrlimit(getattr(resource, key)) for key in keys}


def facts(port, name, paths):
    print(
        json.dumps(
            {
                'status': status(),
                'namespaces': links('/proc/self/ns'),
                'fds': links('/proc/self/fd'),
                'parent': os.getppid(),
                'pids': [entry for entry in os.listdir('/proc') if entry.isdigit()],
                'environment': dict(os.environ),
                'modules': [key for key in sys.modules if key.startswith(('pytest', '_pytest'))],
                'seen': {path: os.path.exists(path) for path in paths},
                'folders': {path: sorted(os.listdir(path)) for path in ('/', '/home', '/etc', '/tmp', '/dev')},
                'writes': writes(),
                'network': network(port, name),
                'interfaces': [interface for _, interface in socket.if_nameindex()],
                'calls': calls(),
                'limits': limits(),
                'host': os.uname().nodename,
            }
        )
    )
