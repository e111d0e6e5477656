# expect: a comment is no such line
# rejected by: test_apt
# Exercise 7.1: a machine
def diagnose_machine(files, want):
    found = []
    debs = [line for line in files['ros2.list'].splitlines() if 'deb ' in line]
    if not debs:
        found.append(Finding('A7.1', 'ros2.list', 'missing', ''))
    for line in debs:
        faults = {'release': line.split()[-2] != want['codename'], 'key': 'signed-by=' not in line}
        found += [Finding('A7.1', 'ros2.list', cause, line) for cause in faults if faults[cause]]
    lines = active(files['.bashrc'])
    sourced = {line: re.match(SETUP, line)[1] for line in lines if re.match(SETUP, line)}
    if want['distro'] not in sourced.values():
        found.append(Finding('A7.2', '.bashrc', 'not sourced', ''))
    found += [Finding('A7.5', '.bashrc', 'other', line) for line in sourced if sourced[line] != want['distro']]
    values = [(line, *line.removeprefix('export ').split('=', 1)) for line in lines if '=' in line]
    domain = [(line, value) for line, name, value in values if name == 'ROS_DOMAIN_ID'] or [('', '0')]
    if int(domain[-1][1]) != want['domain']:
        found.append(Finding('A7.7', '.bashrc', 'domain', domain[-1][0]))
    for line, name, value in values:
        if name == 'PATH' and '$PATH' not in value:
            found.append(Finding('A7.3', '.bashrc', 'PATH', line))
        if name == 'ROS_AUTOMATIC_DISCOVERY_RANGE' and value in ('OFF', 'LOCALHOST'):
            found.append(Finding('A7.7', '.bashrc', 'range', line))
    return found


def repair_machine(files, want):
    found = diagnose_machine(files, want)
    wrong = {finding.evidence: finding.cause for finding in found}
    keep = {name: [line for line in text.splitlines() if wrong.get(line.strip(), 'PATH') == 'PATH']
            for name, text in files.items()}
    bashrc = [line + ':$PATH' * (line.strip() in wrong) for line in keep['.bashrc']]
    bashrc += [f"source /opt/ros/{want['distro']}/setup.bash", f"export ROS_DOMAIN_ID={want['domain']}"]
    sources = keep['ros2.list'] + [DEB.format(**want)] * any(finding.row == 'A7.1' for finding in found)
    return {'.bashrc': '\n'.join(bashrc), 'ros2.list': '\n'.join(sources)}
