"""What every transform buffer can do, and the registry of how to transform and convert types."""

from collections.abc import Callable
from copy import deepcopy
from typing import Any, TypeVar

from geometry_msgs.msg import PointStamped, PoseStamped, PoseWithCovarianceStamped, TransformStamped, Vector3Stamped  # noqa: F401
from rclpy.duration import Duration
from rclpy.time import Time
from sensor_msgs.msg import PointCloud2  # noqa: F401
from std_msgs.msg import Header

#: Do not wait.
NO_TIMEOUT = Duration()

TransformableObject = TypeVar('TransformableObject')
TransformableObjectType = TypeVar('TransformableObjectType')


class TypeException(Exception):
    """No transformation or conversion is registered for a type. Import e.g. `tf2_geometry_msgs` to register some."""

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr


class NotImplementedException(Exception):
    """A subclass of :class:`BufferInterface` does not implement the method."""

    def __init__(self) -> None:
        self.errstr = 'CanTransform or LookupTransform not implemented'
        super().__init__(self.errstr)


class BufferInterface:
    """
    Ask for transforms, and transform stamped objects.

    Subclasses implement the `lookup_…` and `can_…` methods. Transforms take data from the *source* frame into the
    *target* frame; time 0 means the latest time at which they are known.
    """

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self,
        object_stamped: TransformableObject,
        target_frame: str,
        timeout: Duration = NO_TIMEOUT,
        new_type: TransformableObjectType | None = None,
    ) -> TransformableObject:
        """
        Return the object in the target frame, at the time of its own stamp.

        :param object_stamped: anything with a header whose type is registered.
        :param timeout: how long to wait for the transform.
        :param new_type: convert the result to this type.
        :raises TypeException: if the type is not registered; TransformException as the look-up.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        transform = self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        result = do_transform(object_stamped, transform)
        return result if new_type is None else convert(result, new_type)

    def transform_full(
        self,
        object_stamped: TransformableObject,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
        new_type: TransformableObjectType | None = None,
    ) -> TransformableObject:
        """
        Return the object in the target frame at another time, by way of a frame that did not move in between.

        Parameters and exceptions as in :meth:`transform`.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        transform = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout
        )
        result = do_transform(object_stamped, transform)
        return result if new_type is None else convert(result, new_type)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT
    ) -> TransformStamped:
        """Return the transform from the source frame to the target frame."""
        raise NotImplementedException()

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> TransformStamped:
        """Return the transform from the source frame at one time to the target frame at another."""
        raise NotImplementedException()

    def can_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT) -> bool:
        """Return whether the transform from the source frame to the target frame is known."""
        raise NotImplementedException()

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> bool:
        """Return whether the transform between the frames at two times is known."""
        raise NotImplementedException()


def Stamped(obj: TransformableObject, stamp: Time, frame_id: str) -> TransformableObject:
    """Give an object a header (a message's stamp, a frame id), so that a buffer can transform it; return it."""
    obj.header = Header(frame_id=frame_id, stamp=stamp)
    return obj


def _registered(registry: dict, key: Any) -> Callable:
    try:
        return registry[key]
    except KeyError:
        raise TypeException(f'Type {key} is not loaded or supported') from None


class TransformRegistration:
    """Which function transforms which type. There is one registry for the whole process."""

    __type_map = {}

    def print_me(self) -> None:
        """Print the registry."""
        print(TransformRegistration.__type_map)

    def add(
        self,
        key: TransformableObjectType,
        callback: Callable[[TransformableObject, TransformStamped], TransformableObject],
    ) -> None:
        """Register `callback(object, transform) -> object` for a type."""
        TransformRegistration.__type_map[key] = callback

    def get(
        self, key: TransformableObjectType
    ) -> Callable[[TransformableObject, TransformStamped], TransformableObject]:
        """Return the function for a type; TypeException if there is none."""
        return _registered(TransformRegistration.__type_map, key)


class ConvertRegistration:
    """Which functions convert which types, directly or by way of a message. One registry for the whole process."""

    __to_msg_map = {}
    __from_msg_map = {}
    __convert_map = {}

    def add_from_msg(self, key: TransformableObjectType, callback: Callable[[Any], TransformableObject]) -> None:
        """Register how to make the type from its message."""
        ConvertRegistration.__from_msg_map[key] = callback

    def add_to_msg(self, key: TransformableObjectType, callback: Callable[[TransformableObject], Any]) -> None:
        """Register how to make a message from the type."""
        ConvertRegistration.__to_msg_map[key] = callback

    def add_convert(
        self,
        key: tuple[TransformableObjectType, TransformableObjectType],
        callback: Callable[[Any], TransformableObject],
    ) -> None:
        """Register a direct conversion; the key is `(from type, to type)`."""
        ConvertRegistration.__convert_map[key] = callback

    def get_from_msg(self, key: TransformableObjectType) -> Callable[[Any], TransformableObject]:
        """Return the function registered by :meth:`add_from_msg`; TypeException if there is none."""
        return _registered(ConvertRegistration.__from_msg_map, key)

    def get_to_msg(self, key: TransformableObjectType) -> Callable[[TransformableObject], Any]:
        """Return the function registered by :meth:`add_to_msg`; TypeException if there is none."""
        return _registered(ConvertRegistration.__to_msg_map, key)

    def get_convert(
        self, key: tuple[TransformableObjectType, TransformableObjectType]
    ) -> Callable[[Any], TransformableObject]:
        """Return the function registered by :meth:`add_convert`; TypeException if there is none."""
        return _registered(ConvertRegistration.__convert_map, key)


def convert(a: TransformableObject, b_type: TransformableObjectType) -> TransformableObject:
    """
    Return the object as another type: by a registered conversion, as a copy, or by way of a message.

    :raises TypeException: if there is no way.
    """
    registration = ConvertRegistration()
    try:
        direct = registration.get_convert((type(a), b_type))
    except TypeException:
        if type(a) is b_type:
            return deepcopy(a)
        return registration.get_from_msg(b_type)(registration.get_to_msg(type(a))(a))
    return direct(a)
