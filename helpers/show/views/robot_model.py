"""The display of a robot: the shapes of its description, each link where tf2 says that it is."""

import numpy as np
import urdf_reader

from helpers.show.views import meshes
from helpers.show.views.display import no_transform
from helpers.show.views.scene import part
from helpers.show.views.shapes import LIGHT, Box, Cylinder, Mesh, Shape, Sphere
from helpers.show.views.topic_display import TopicDisplay


class RobotModel(TopicDisplay):
    """The links of a robot (a URDF on a std_msgs/String topic, as robot_state_publisher sends it).

    A link without a transform to the fixed frame is not shown, and the status names it.

    :param topic: name of the topic with the description.
    :param prefix: before the names of links, as robot_state_publisher's ``frame_prefix``.
    :param collision: show the shapes that touch (``<collision>``), not those that are seen (``<visual>``).
    :param opacity: 0 to 1.
    :param qos: QoS or depth; None: as in RViz, the last one, transient local.
    """

    def __init__(
        self,
        topic: str = '/robot_description',
        prefix: str = '',
        collision: bool = False,
        opacity: float = 1.0,
        qos=None,
    ):
        super().__init__(topic, qos)
        self.prefix, self.collision, self.opacity = prefix, collision, opacity
        self.robot: urdf_reader.Robot | None = None  #: what the last good description says
        self._shown: list[str] = []  # links with shapes
        self._complaints: list[str] = []

    def message_type(self):
        from std_msgs.msg import String

        return String

    @staticmethod
    def default_qos():
        from rclpy.qos import DurabilityPolicy, QoSProfile

        return QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

    def on_start(self) -> None:
        super().on_start()
        self.robot, self._shown, self._complaints = None, [], []

    def take(self, message) -> None:
        """Take a description; what is on the screen is replaced."""
        self.scene.clear()
        self.robot, self._shown, self._complaints = None, [], []
        try:
            self.robot = urdf_reader.read(message.data)
        except urdf_reader.UrdfError as error:
            self._complaints.append(f'bad robot description: {error}')
            return
        for link in self.robot.links.values():
            shapes = link.collisions if self.collision else link.visuals
            for number, visual in enumerate(shapes):
                self._add(link.name, number, visual)
            if shapes:
                self._shown.append(link.name)
                self.scene.appearance(part(link.name), visible=False, opacity=self.opacity)
        if not self._shown:
            kind = 'collision' if self.collision else 'visual'
            self._complaints.append(f'no link of robot [{self.robot.name}] has a <{kind}>')

    def _add(self, link: str, number: int, visual: urdf_reader.Collision) -> None:
        try:
            shape, scale = _shape(visual)
        except urdf_reader.UrdfError as error:
            self._complaints.append(f'link [{link}]: {error}')
            return
        path = f'{part(link)}/{number}'
        self.scene.set(path, shape)
        self.scene.pose(path, visual.origin.matrix @ np.diag((*scale, 1.0)))
        colour = getattr(visual, 'colour', None)
        if colour is not None:
            self.scene.appearance(path, opacity=colour[3])

    def update(self, fixed_frame, time) -> None:
        missing = []
        for link in self._shown:
            pose = self.transform(fixed_frame, self.prefix + link, time)
            self.scene.appearance(part(link), visible=pose is not None)
            if pose is None:
                missing.append(link)
            else:
                self.scene.pose(part(link), pose)
        problems = list(self._complaints)
        if missing:
            names = ', '.join(f'[{self.prefix}{link}]' for link in missing)
            problems.append(no_transform(names, fixed_frame))
        if self.robot is None and not problems:
            problems.append(self.silence())
        self.problem = '\n'.join(filter(None, problems))


def _shape(visual: urdf_reader.Collision) -> tuple[Shape, tuple]:
    """The shape of a visual or collision, and the scale of its axes."""
    given = getattr(visual, 'colour', None)
    colour = given[:3] if given is not None else LIGHT
    match visual.geometry:
        case urdf_reader.Box(size):
            return Box(size, colour), (1.0, 1.0, 1.0)
        case urdf_reader.Cylinder(radius, length):
            return Cylinder(radius, length, colour), (1.0, 1.0, 1.0)
        case urdf_reader.Sphere(radius):
            return Sphere(radius, colour), (1.0, 1.0, 1.0)
        case urdf_reader.Mesh(filename, scale):
            vertices, faces, own = meshes.load(filename)
            return Mesh(vertices, faces, colour if given is not None or own is None else own), scale
    raise TypeError(f'no shape for {visual.geometry}')
