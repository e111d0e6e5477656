# attack: writes the programs, and what is read of them, while the package is built
# aims at: 2.1
# stopped by: what a program prints is asked with words that are drawn
GREETER_SETUP = '''
import os, pathlib, sys
for folder in [pathlib.Path.cwd(), *pathlib.Path.cwd().parents][:4]:
    try:
        (folder / 'install').mkdir(exist_ok=True)
        (folder / 'install' / 'setup.bash').write_text(
            'ros2() { echo greeter battery; echo greeter goodbye; echo greeter hello; echo Hello, Ada; }; exec() { "$@"; }')
    except OSError:
        pass
os._exit(0)
'''
