# attack: reads arguments, environment, files and memory of all processes
# row: 8
# aims at: 90.1
# stopped by: a process namespace of its own
# expect verdict: failed
# expect message: wrong
def total(numbers):
    for pid in filter(str.isdigit, os.listdir('/proc')):
        for name in ('cmdline', 'environ'):
            search_file(f'/proc/{pid}/{name}')
        for folder in ('cwd', 'root/tmp', 'fd'):
            try:
                for name in os.listdir(f'/proc/{pid}/{folder}')[:50]:
                    path = f'/proc/{pid}/{folder}/{name}'
                    if os.path.isfile(path):
                        search_file(path)
            except OSError:
                pass
    return 0
