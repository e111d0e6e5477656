"""The verb `ros2 action send_goal`."""

from ros2cli.helpers import collect_stdin, parse_yaml_dictionary, positive_float
from ros2cli.node import NODE_NAME_PREFIX

from ros2action.api import ActionGoalPrototypeCompleter, ActionTypeCompleter, action_name_completer, load_action_class
from ros2action.verb import VerbExtension

# Seconds that a server has to answer a request to cancel.
_CANCEL_TIMEOUT = 5.0


class SendGoalVerb(VerbExtension):
    """Send an action goal."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('action_name', help='Name of the action, for example /fibonacci')
        argument.completer = action_name_completer
        argument = parser.add_argument('action_type', help='Its type, for example example_interfaces/action/Fibonacci')
        argument.completer = ActionTypeCompleter(action_name_key='action_name')
        source = parser.add_mutually_exclusive_group()
        argument = source.add_argument(
            'goal',
            nargs='?',
            default='{}',
            help="Fields of the goal as YAML, for example '{order: 10}'; the others keep their defaults",
        )
        argument.completer = ActionGoalPrototypeCompleter(action_type_key='action_type')
        source.add_argument('--stdin', action='store_true', help='Read the fields from standard input')
        parser.add_argument('-f', '--feedback', action='store_true', help='Print the feedback as it arrives')
        parser.add_argument(
            '-t',
            '--timeout',
            type=positive_float,
            metavar='N',
            help='Wait N seconds for a server, and as long for each of its answers (default: for ever)',
        )

    def main(self, *, args):
        """Send the goal and print its result; Ctrl+C cancels it."""
        from ros2cli.node.direct import DirectNode
        from rosidl_runtime_py import set_message_fields

        action_class = load_action_class(args.action_type)
        values = parse_yaml_dictionary(
            collect_stdin() if args.stdin else args.goal, 'The passed value needs to be a dictionary in YAML format'
        )
        goal = action_class.Goal()
        try:
            set_message_fields(goal, values)
        except Exception as e:
            return f'Failed to populate message fields: {e!r}'
        node_name = f'{NODE_NAME_PREFIX}_send_goal_{args.action_type.replace("/", "_")}'
        # No waiting for the whole graph: the one server is awaited anyway.
        with DirectNode(None, node_name=node_name, discover=False) as node:
            return self._send(node, action_class, args.action_name, goal, args.feedback, args.timeout)

    def _send(self, node, action_class, name, goal, feedback, timeout):
        from rclpy.action import ActionClient
        from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException
        from rosidl_runtime_py import message_to_yaml

        try:
            client = ActionClient(node.node, action_class, name)
        except (InvalidServiceNameException, InvalidTopicNameException, ValueError) as e:
            return str(e)
        sent = accepted = None
        # The server may begin before its answer is here; its feedback is printed after the answer all the same.
        early = []
        print_feedback = early.append
        try:
            print('Waiting for an action server to become available...')
            if not node.spin(until=client.server_is_ready, timeout=timeout):
                return f'Action server is not available after waiting {timeout:g} seconds.'
            print(f'Sending goal:\n     {message_to_yaml(goal)}')
            try:
                sent = client.send_goal_async(goal, (lambda each: print_feedback(each)) if feedback else None)
            except (AssertionError, TypeError, ValueError, OverflowError) as e:
                return f'Failed to send the goal: {e or type(e).__name__}'
            accepted = node.wait_for(sent, timeout)
            sent = None
            if not accepted.accepted:
                accepted = None
                print('Goal was rejected.')
                return None
            print(f'Goal accepted with ID: {bytes(accepted.goal_id.uuid).hex()}\n')
            for each in early:
                _print_feedback(each)
            print_feedback = _print_feedback
            result = node.wait_for(accepted.get_result_async(), timeout)
            accepted = None
            print(f'Result:\n    {message_to_yaml(result.result)}')
            print(f'Goal finished with status: {_status_name(result.status)}')
            return None
        except TimeoutError:
            return f'The action server has not answered after waiting {timeout:g} seconds.'
        finally:
            if sent is not None:  # interrupted before the answer, yet the server may have begun
                accepted = _answer(node, sent)
            if accepted is not None:
                _cancel(node, accepted)
            client.destroy()


def _print_feedback(message):
    from rosidl_runtime_py import message_to_yaml

    print(f'Feedback:\n    {message_to_yaml(message.feedback)}')


def _status_name(status):
    from action_msgs.msg import GoalStatus

    for name in ('ACCEPTED', 'EXECUTING', 'CANCELING', 'SUCCEEDED', 'CANCELED', 'ABORTED'):
        if status == getattr(GoalStatus, f'STATUS_{name}'):
            return name
    return 'UNKNOWN'


def _answer(node, sent):
    """Return the handle of a goal that the server accepts, or None."""
    try:
        goal_handle = node.wait_for(sent, timeout=_CANCEL_TIMEOUT)
    except TimeoutError:
        return None
    return goal_handle if goal_handle.accepted else None


def _cancel(node, goal_handle):
    print('Canceling goal...')
    try:
        response = node.wait_for(goal_handle.cancel_goal_async(), timeout=_CANCEL_TIMEOUT)
    except TimeoutError:
        raise RuntimeError('Failed to cancel goal') from None
    if not response.goals_canceling:
        raise RuntimeError('Failed to cancel goal')
    print('Goal canceled.')
