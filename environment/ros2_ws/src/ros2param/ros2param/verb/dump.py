"""The verb `ros2 param dump`."""

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import add_node_arguments, call_get_parameters, call_list_parameters, get_value, node_is_there
from ros2param.verb import VerbExtension


class DumpVerb(VerbExtension):
    """Show all of the parameters of a node in a YAML file format."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_node_arguments(parser)

    def main(self, *, args):
        """Print a parameter file."""
        import yaml
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            if not node_is_there(node, name, args.include_hidden_nodes, args.timeout):
                return 'Node not found'
            names = call_list_parameters(node=node, node_name=name)
            values = _values(node, name, names)
        parameters = {}
        for parameter_name, value in values.items():
            _insert(parameters, parameter_name, get_value(parameter_value=value))
        print(yaml.dump({name: {'ros__parameters': parameters}}, default_flow_style=False))


def _values(node, node_name, names):
    """Return name -> value of those that are set: nodes of rclpy answer with nothing if one of them is not."""
    values = call_get_parameters(node=node, node_name=node_name, parameter_names=names).values
    if len(values) == len(names):
        return dict(zip(names, values, strict=True))
    answers = {one: call_get_parameters(node=node, node_name=node_name, parameter_names=[one]).values for one in names}
    return {one: answer[0] for one, answer in answers.items() if answer}


def _insert(parameters, name, value):
    """Put `a.b` under `a`, as parameter files are."""
    *groups, last = name.split('.')
    for group in groups:
        below = parameters.setdefault(group, {})
        if not isinstance(below, dict):  # both `a` and `a.b` exist
            break
        parameters = below
    else:
        parameters[last] = value
        return
    parameters[name] = value
