"""The options of a learner's node class: what it hands on to Node, for exercises 8.2 and 8.7."""

from helpers.runner import expect


def check_options(learner, kind: str, rule: str) -> None:
    """Fail unless the class `kind` hands its keyword arguments on to Node."""
    arguments = ['--ros-args', '-r', f'__node:=robot_{learner.random.randint(100, 999)}']
    wanted = arguments[-1].replace('__node:=', '/')
    found = learner.start(kind, cli_args=arguments).name
    expect(
        found == wanted,
        f'{kind}(cli_args={arguments}) makes a node that is called {found}, expected {wanted}. What is given to '
        '`__init__` as **options goes on to Node: `super().__init__(…, **options)`, as in the given lines.',
        rule,
    )
