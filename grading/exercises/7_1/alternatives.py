from grading.variants import Alternative

# With the numbers that faults had before they had names.
ALTERNATIVES = [
    Alternative('a_loop', source=r'''
def assignment(line):
    name, sign, value = line.replace('export ', '', 1).partition('=')
    return (name.strip(), value.strip()) if sign else ('', '')


def diagnose_machine(files, want):
    found, debs, right, domain = [], 0, False, ('', 0)
    for line in active(files['ros2.list']):
        words = line.split()
        if words[0] == 'deb':
            debs += 1
            if want['codename'] not in words:
                found.append(Finding('A7.1', 'ros2.list', 'release', line))
            if not re.search(r'\[.*signed-by=.*\]', line):
                found.append(Finding('A7.1', 'ros2.list', 'key', line))
    if debs == 0:
        found.append(Finding('A7.1', 'ros2.list', 'missing', ''))
    for line in active(files['.bashrc']):
        name, value = assignment(line)
        if setup := re.match(SETUP, line):
            right |= setup[1] == want['distro']
            if setup[1] != want['distro']:
                found.append(Finding('A7.5', '.bashrc', 'other', line))
        elif name == 'PATH' and not re.search(r'\$\{?PATH\b', value):
            found.append(Finding('A7.3', '.bashrc', 'PATH', line))
        elif name == 'ROS_DOMAIN_ID':
            domain = line, int(value)
        elif name == 'ROS_AUTOMATIC_DISCOVERY_RANGE' and value in {'OFF', 'LOCALHOST'}:
            found.append(Finding('A7.7', '.bashrc', 'range', line))
    found += [] if right else [Finding('A7.2', '.bashrc', 'not sourced', '')]
    return found + [Finding('A7.7', '.bashrc', 'domain', domain[0])] * (domain[1] != want['domain'])


def repair_machine(files, want):
    files, source = dict(files), f"source /opt/ros/{want['distro']}/setup.bash"
    for finding in diagnose_machine(files, want):
        lines = files[finding.where].splitlines()
        lines = [line for line in lines if not finding.evidence or line.strip() != finding.evidence]
        name, value = assignment(finding.evidence)
        lines += {'not sourced': [source], 'domain': [f"ROS_DOMAIN_ID={want['domain']}"],
                  'PATH': [f'export PATH=$PATH:{value}']}.get(finding.cause, [])
        files[finding.where] = '\n'.join(lines) + '\n'
        if finding.row == 'A7.1' and DEB.format(**want) not in lines:
            files['ros2.list'] += DEB.format(**want) + '\n'
    return files
'''),
]
