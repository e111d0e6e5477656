"""Components, the nodes that a container loads: they are C++, and there is none here. What is said instead."""

from launch.frontend import Entity, Parser, expose_action

NAMES = {'ComposableNode', 'ComposableNodeContainer', 'LoadComposableNodes'}
_REASON = (
    'is not available: it loads nodes into a container, which is C++, and this installation has nodes in Python only. '
    'Launch each of them as a node of its own'
)


def error(name: str, module: str) -> Exception:
    """Return the error of a name that a module does not have."""
    if name in NAMES:
        return ImportError(f'{name} {_REASON}, with launch_ros.actions.Node.', name=module)
    return AttributeError(f'module {module!r} has no attribute {name!r}')


@expose_action('node_container')
@expose_action('load_composable_node')
def parse_container(entity: Entity, parser: Parser):
    """
    Refuse a container in an XML or YAML file.

    :raises RuntimeError: always
    """
    raise RuntimeError(f'<{entity.type_name}> {_REASON}, with <node>.')
