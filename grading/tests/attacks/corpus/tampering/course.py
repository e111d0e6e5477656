# attack: changes the runner, the tests and the environment for those who come after
# row: 9
# aims at: 90.1
# stopped by: all but its own temporary folders is read-only
# expect verdict: failed
# expect message: wrong
def total(numbers):
    import helpers
    import rclpy
    for module in (helpers, rclpy, sys.modules['helpers.runner'], os):
        folder = os.path.dirname(os.path.abspath(module.__file__))
        touch(module.__file__)
        plant(folder)
        if os.path.exists(os.path.join(folder, COOKIE)):
            tell('TOUCHED', folder)
    for folder in ('/', '/usr', '/etc', '/var', '/opt', '/srv', '/dev', '/proc', '/sys', sys.prefix):
        plant(folder)
        if os.path.exists(os.path.join(folder, COOKIE)):
            tell('TOUCHED', folder)
            os.unlink(os.path.join(folder, COOKIE))
    return 0
