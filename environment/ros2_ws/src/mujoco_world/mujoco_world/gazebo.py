"""The same scenes for Gazebo Harmonic: a `Scene` as an SDF world."""

from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from mujoco_world.scene import Scene

# What a world needs besides its models: physics, spawning and moving, the window, sensors that render.
SYSTEMS = {
    'gz-sim-physics-system': 'gz::sim::systems::Physics',
    'gz-sim-user-commands-system': 'gz::sim::systems::UserCommands',
    'gz-sim-scene-broadcaster-system': 'gz::sim::systems::SceneBroadcaster',
    'gz-sim-sensors-system': 'gz::sim::systems::Sensors',
}


def sdf(scene: Scene) -> str:
    """Return the world of a scene, without the robot, as the text of an SDF file (version 1.10)."""
    root = Element('sdf', version='1.10')
    world = SubElement(root, 'world', name=scene.name)
    physics = SubElement(world, 'physics', name='2ms', type='ignored')
    _texts(physics, max_step_size='0.002', real_time_factor='1.0')
    for file, name in SYSTEMS.items():
        plugin = SubElement(world, 'plugin', filename=file, name=name)
        if name.endswith('Sensors'):
            _texts(plugin, render_engine='ogre2')
    sun = SubElement(world, 'light', type='directional', name='sun')
    _texts(sun, pose='0 0 10 0 0 0', cast_shadows='true', diffuse='0.9 0.9 0.9 1', direction='-0.4 0.2 -0.9')
    plane = '<plane><normal>0 0 1</normal><size>40 40</size></plane>'
    world.append(_model('floor', plane, '0 0 0 0 0 0', '0.87 0.87 0.85 1'))
    for wall in scene.walls:
        box = f'<box><size>{wall.size[0]:g} {wall.size[1]:g} {wall.height:g}</size></box>'
        pose = f'{wall.at[0]:g} {wall.at[1]:g} {wall.height / 2:g} 0 0 0'
        world.append(_model(wall.name, box, pose, ' '.join(f'{part:g}' for part in wall.colour)))
    for name, (x, y, _) in scene.stations.items():
        colour = ' '.join(f'{part:g}' for part in scene.colours.get(name, (0.45, 0.47, 0.52, 1.0)))
        disc = '<cylinder><radius>0.22</radius><length>0.002</length></cylinder>'
        world.append(_model(f'station_{name}', disc, f'{x:g} {y:g} 0.001 0 0 0', colour, touches=False))
    ElementTree.indent(root)
    return '<?xml version="1.0"?>\n' + ElementTree.tostring(root, encoding='unicode') + '\n'


def _model(name: str, shape: str, pose: str, colour: str, touches: bool = True) -> Element:
    """A model that never moves, of one shape."""
    model = Element('model', name=name)
    _texts(model, static='true', pose=pose)
    link = SubElement(model, 'link', name='link')
    for kind in ('collision', 'visual') if touches else ('visual',):
        part = SubElement(link, kind, name=kind)
        SubElement(part, 'geometry').append(ElementTree.fromstring(shape))
        if kind == 'visual':
            _texts(SubElement(part, 'material'), ambient=colour, diffuse=colour)
    return model


def _texts(element: Element, **texts: str) -> None:
    for name, text in texts.items():
        SubElement(element, name).text = text
