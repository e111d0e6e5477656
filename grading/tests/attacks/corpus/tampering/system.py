# attack: changes settings of the kernel
# row: 28
# aims at: 90.1
# stopped by: no root, no capability
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for path in ('/proc/sys/kernel/core_pattern', '/proc/sys/kernel/hostname', '/proc/sysrq-trigger',
                 '/proc/sys/vm/drop_caches', '/sys/kernel/uevent_helper', '/proc/self/oom_score_adj_', '/dev/mem',
                 '/dev/kmsg', '/dev/sda', '/dev/vda', '/sys/fs/cgroup/cgroup.procs'):
        touch(path)
    with open('/proc/self/status') as status:
        for line in status:
            if line.startswith(('CapEff', 'CapPrm', 'CapBnd')) and int(line.split()[1], 16):
                tell('SEEN', line)
    if os.getuid() == 0 or os.geteuid() == 0:
        tell('SEEN root')
    return 0
