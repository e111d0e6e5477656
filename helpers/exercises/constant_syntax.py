"""What counts as a constant: an expression that makes the same value wherever it stands, judged from its syntax."""

import ast

# Calls that make a constant when their arguments are constant: quickly, and of which nobody else notices anything.
_VALUE_TYPES = {
    *('QoSProfile', 'Duration', 'Time', 'Path', 'timedelta', 'namedtuple', 'partial', 'array', 'compile'),
    *('Enum', 'IntEnum', 'Counter', 'OrderedDict', 'defaultdict', 'deque', 'Decimal', 'Fraction', 'Random', 'TypeVar'),
    *('chain', 'count', 'cycle', 'product', 'repeat', 'itemgetter', 'attrgetter', 'getLogger'),
    *('bool', 'bytes', 'complex', 'dict', 'float', 'frozenset', 'int', 'list', 'range', 'set', 'str', 'tuple'),
    *('abs', 'all', 'any', 'enumerate', 'len', 'max', 'min', 'pow', 'reversed', 'round', 'sorted', 'sum', 'zip'),
    *('acos', 'asin', 'atan', 'atan2', 'ceil', 'cos', 'degrees', 'exp', 'floor', 'hypot', 'log', 'radians', 'sin'),
    *('sqrt', 'tan', 'arange', 'deg2rad', 'eye', 'full', 'identity', 'linspace', 'ones', 'zeros'),
}
# Messages, locks and callback groups: of those that demonstrations make, no program may live by accident. So only what
# is written as a constant, in capitals, is taken.
_MADE_AS_CONSTANTS = {
    *('Bool', 'ColorRGBA', 'Empty', 'Float32', 'Float64', 'Header', 'Int8', 'Int16', 'Int32', 'Int64', 'String'),
    *('UInt8', 'UInt16', 'UInt32', 'UInt64', 'Point', 'Pose', 'PoseStamped', 'PointStamped', 'Quaternion', 'Transform'),
    *('TransformStamped', 'Twist', 'TwistStamped', 'Vector3', 'BatteryState', 'JointState', 'LaserScan', 'Range'),
    *('MapMetaData', 'OccupancyGrid', 'Odometry', 'FloatingPointRange', 'IntegerRange', 'ParameterDescriptor'),
    *('SetParametersResult', 'Lock', 'RLock', 'MutuallyExclusiveCallbackGroup', 'ReentrantCallbackGroup'),
}
_VALUE_METHODS = {'format', 'items', 'join', 'keys', 'split', 'values'}  # of texts and dictionaries


def is_name(target: ast.expr) -> bool:
    """Names that are bound: an attribute of an object is none, which a demonstration has made."""
    match target:
        case ast.Tuple(elts=parts) | ast.List(elts=parts):
            return all(map(is_name, parts))
        case ast.Starred(value=part):
            return is_name(part)
    return isinstance(target, ast.Name)


def is_constant(node: ast.expr) -> bool:
    """A literal, names and attributes, what is computed of these by signs, or a value such as a QoSProfile of them."""
    match node:
        case ast.Constant() | ast.Name():
            return True
        case ast.Attribute(value=value) | ast.UnaryOp(operand=value) | ast.Starred(value=value):
            return is_constant(value)
        case ast.BinOp(left=left, right=right):
            return is_constant(left) and is_constant(right)
        case ast.Compare(left=left, comparators=others):
            return all(map(is_constant, [left, *others]))
        case ast.IfExp(test=test, body=one, orelse=other):
            return all(map(is_constant, [test, one, other]))
        case ast.Subscript(value=value, slice=key):
            return is_constant(value) and is_constant(key)
        case ast.Slice(lower=lower, upper=upper, step=step):
            return all(part is None or is_constant(part) for part in (lower, upper, step))
        case ast.Tuple(elts=items) | ast.List(elts=items) | ast.Set(elts=items):
            return all(map(is_constant, items))
        case ast.BoolOp(values=items) | ast.JoinedStr(values=items):
            return all(map(is_constant, items))
        case ast.FormattedValue(value=value, format_spec=spec):
            return is_constant(value) and (spec is None or is_constant(spec))
        case ast.ListComp(elt=item, generators=loops) | ast.SetComp(elt=item, generators=loops):
            return is_constant(item) and all(map(_is_loop, loops))
        case ast.DictComp(key=key, value=value, generators=loops):
            return is_constant(key) and is_constant(value) and all(map(_is_loop, loops))
        case ast.Dict(keys=keys, values=values):
            return all(is_constant(item) for item in [*keys, *values] if item is not None)
        case ast.Lambda():
            return True
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name) as made, args=args, keywords=keywords):
            known = name in _VALUE_TYPES or isinstance(made, ast.Attribute) and name in _VALUE_METHODS
            return known and all(map(is_constant, [made, *args, *(keyword.value for keyword in keywords)]))
    return False


def is_made_as_constant(node: ast.expr) -> bool:
    """Such as ``Twist(linear=Vector3(x=0.5))``, or a constant."""
    match node:
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name), args=args, keywords=keywords):
            values = [*args, *(keyword.value for keyword in keywords)]
            return is_constant(node) or name in _MADE_AS_CONSTANTS and all(map(is_made_as_constant, values))
    return is_constant(node)


def _is_loop(loop: ast.comprehension) -> bool:
    """A part of a comprehension that goes through a constant."""
    return not loop.is_async and is_name(loop.target) and all(map(is_constant, [loop.iter, *loop.ifs]))
