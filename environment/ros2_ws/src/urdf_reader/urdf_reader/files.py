"""The files that a robot description names."""

from pathlib import Path
from urllib.parse import unquote, urlsplit

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

from urdf_reader.model import UrdfError


def resolve(filename: str) -> Path:
    """
    Return the path of a mesh's file: ``package://PACKAGE/path``, ``file:///path``, or an absolute path.

    :raises UrdfError: there is no such package, no such file, or the name is of another kind.
    """
    parts = urlsplit(filename)
    if parts.scheme == 'package':
        try:
            path = Path(get_package_share_directory(parts.netloc), unquote(parts.path).lstrip('/'))
        except (PackageNotFoundError, ValueError):
            raise UrdfError(
                f'{filename}: there is no package {parts.netloc!r}; build it and source its workspace'
            ) from None
    elif parts.scheme in ('', 'file'):
        path = Path(unquote(parts.path))
        if not path.is_absolute():
            raise UrdfError(f'{filename}: a mesh is named by package://PACKAGE/path or by an absolute path')
    else:
        raise UrdfError(f'{filename}: cannot read {parts.scheme}://; use package:// or file://')
    if not path.is_file():
        raise UrdfError(f'{filename}: there is no file {path}')
    return path
