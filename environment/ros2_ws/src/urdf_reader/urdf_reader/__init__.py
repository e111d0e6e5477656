"""
Robot descriptions (URDF) as Python objects.

`read(text)` gives a :class:`Robot` or raises :class:`UrdfError` with one line that says where and why.
`resolve(filename)` finds the file that a ``<mesh filename="package://…"/>`` names.
"""

from urdf_reader.files import resolve
from urdf_reader.model import (
    Box,
    Collision,
    Cylinder,
    Inertial,
    Joint,
    Limit,
    Link,
    Mesh,
    Mimic,
    Pose,
    Robot,
    Sphere,
    UrdfError,
    Visual,
)
from urdf_reader.reader import read

__all__ = [
    'Box',
    'Collision',
    'Cylinder',
    'Inertial',
    'Joint',
    'Limit',
    'Link',
    'Mesh',
    'Mimic',
    'Pose',
    'Robot',
    'Sphere',
    'UrdfError',
    'Visual',
    'read',
    'resolve',
]
