"""`parameter_sliders`: a slider for each bounded parameter of a running node, as rqt_reconfigure has them."""

from rclpy.parameter import parameter_value_to_python

from helpers.kernel import nodes
from helpers.kernel.spinning import spinning
from helpers.kernel.waiting import wait_for
from helpers.show.sliders import Slider, Sliders

_PATIENCE = 10.0  # s, for an answer of the node


def parameter_sliders(node_name: str) -> Sliders:
    """Show a slider for each parameter of a running node that has bounds, also in another process.

    Each move asks the node to set the parameter; below the sliders stands what it answered. A node of this process
    (``/_parameter_sliders``) asks; it ends with the sliders.

    :param node_name: such as ``/battery_monitor``.
    :raises TimeoutError: nobody answers in 10 s: there is no such node, or nobody spins it.
    :raises ValueError: no parameter of the node has bounds.
    """
    import rclpy
    from rclpy.parameter_client import AsyncParameterClient

    if not rclpy.ok():
        raise RuntimeError('ROS is not started: run helpers.ros.start() first')
    node = rclpy.create_node('_parameter_sliders', enable_rosout=False, start_parameter_services=False)
    spinning(node)
    try:
        client = AsyncParameterClient(node, node_name)
        wait_for(client.services_are_ready, _PATIENCE, message=f'the parameter services of {node_name}')
        sliders = _sliders(client)
        if not sliders:
            raise ValueError(f'no parameter of {node_name} has bounds: declare it with a range in its descriptor')
        setter = _Setter(client, node_name, {name: slider.value for name, slider in sliders.items()})
        setter.sliders = Sliders(setter, node, **sliders)
    except BaseException:
        nodes.destroy(node)
        raise
    return setter.sliders


class _Setter:
    """Asks the node to set what has moved, and tells its answer below the sliders."""

    sliders: Sliders

    def __init__(self, client, node_name: str, values: dict):
        self._client, self._node_name, self._values = client, node_name, values

    def __call__(self, **values) -> str | None:
        from rclpy.parameter import Parameter

        moved = {name: value for name, value in values.items() if value != self._values[name]}
        if not moved:
            return f'move a slider: {self._node_name} is asked to set the parameter'
        self._values = values
        asked = self._client.set_parameters([Parameter(name, value=value) for name, value in moved.items()])
        what = ', '.join(f'{name} = {value:.4g}' for name, value in moved.items())
        asked.add_done_callback(lambda answer: self.sliders.show(f'{what}: {_said(answer.result())}'))
        return f'{what}: asked'


def _said(answer) -> str:
    refused = [result.reason for result in answer.results if not result.successful]
    return f'refused: {"; ".join(refused)}' if refused else 'done'


def _sliders(client) -> dict[str, Slider]:
    """A slider for each parameter of the node with bounds, by name, at its value."""
    names = _answer(client.list_parameters()).result.names
    found = {}
    for descriptor in _answer(client.describe_parameters(names)).descriptors:
        bounds = (*descriptor.floating_point_range, *descriptor.integer_range)
        if bounds and not descriptor.read_only:
            found[descriptor.name] = Slider(bounds[0].from_value, bounds[0].to_value, help=descriptor.description)
    values = _answer(client.get_parameters(list(found))).values if found else []
    return {
        name: slider._replace(value=parameter_value_to_python(value))
        for (name, slider), value in zip(found.items(), values, strict=True)
    }


def _answer(future):
    wait_for(future.done, _PATIENCE, message='the answer of the node')
    return future.result()
