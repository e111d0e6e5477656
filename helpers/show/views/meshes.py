"""Files of triangles: STL, OBJ, PLY, glTF; and Collada (.dae) where pycollada is installed."""

from functools import lru_cache

import numpy as np
from urdf_reader import UrdfError, resolve


@lru_cache(maxsize=64)
def load(filename: str) -> tuple[np.ndarray, np.ndarray, tuple | None]:
    """Return the vertices (N x 3), the faces (M x 3 indices) and the main colour (or None) of a mesh's file.

    :param filename: ``package://PACKAGE/path``, ``file:///path`` or an absolute path.
    :raises UrdfError: there is no such file, or it cannot be read; one line.
    """
    import trimesh

    path = resolve(filename)
    try:
        mesh = trimesh.load(path, force='mesh')
        vertices, faces = np.asarray(mesh.vertices), np.asarray(mesh.faces)
    except ImportError as error:
        raise UrdfError(
            f'{filename}: reading {path.suffix} files needs another package: pip install {error.name or "pycollada"}'
        ) from None
    except Exception as error:  # each reader of a format has its own kinds
        hint = '; .dae files need pycollada: pip install pycollada' if path.suffix.lower() == '.dae' else ''
        raise UrdfError(f'{filename}: this is no mesh that can be read: {error}{hint}') from None
    if len(faces) == 0:
        raise UrdfError(f'{filename}: there are no triangles in it')
    visual = mesh.visual
    colour = getattr(visual, 'main_color', None) if visual.kind in ('face', 'vertex') else None
    if colour is None and visual.kind == 'texture':
        colour = visual.material.main_color
    return vertices, faces, None if colour is None else tuple(float(part) / 255 for part in colour[:3])
