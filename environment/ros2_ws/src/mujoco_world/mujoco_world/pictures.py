"""Pictures of a MuJoCo model without a screen."""

import atexit
import weakref
from concurrent.futures import ThreadPoolExecutor

import mujoco
import numpy


class NoPicturesError(RuntimeError):
    """This machine cannot render; the text says what it lacks."""


class Pictures:
    """Makes pictures of one model.

    :param width, height: in pixels; the model's off-screen buffer must be as large.
    :raises NoPicturesError: there is no OpenGL without a screen (EGL).
    """

    def __init__(self, model: mujoco.MjModel, width: int, height: int):
        self._shapes = mujoco.MjvOption()
        self._size = (height, width)
        self._thread = ThreadPoolExecutor(1, thread_name_prefix='pictures')  # OpenGL's context belongs to one thread
        try:
            self._renderer = self._thread.submit(self._open, model).result()
        except NoPicturesError:
            self._thread.shutdown()
            raise
        atexit.register(_at_exit, weakref.ref(self))

    def _open(self, model: mujoco.MjModel):
        try:
            return mujoco.Renderer(model, *self._size)
        except Exception as error:  # PyOpenGL raises whatever its loader raises
            reason = ' '.join(str(error).split()) or type(error).__name__
            raise NoPicturesError(
                'no camera pictures: OpenGL without a screen (EGL) does not work here. On Debian or '
                f'Ubuntu: sudo apt-get install libegl1 libgl1-mesa-dri. ({reason[:120]})'
            ) from None

    def take(self, data: mujoco.MjData, camera: str | mujoco.MjvCamera, groups: tuple[int, ...]) -> numpy.ndarray:
        """Return a picture, height x width x 3, uint8, red green blue. `groups` are the groups of geoms to show."""
        return self._thread.submit(self._take, data, camera, groups).result()

    def _take(self, data, camera, groups) -> numpy.ndarray:
        self._shapes.geomgroup[:] = 0
        self._shapes.geomgroup[list(groups)] = 1
        self._renderer.update_scene(data, camera, self._shapes)
        return self._renderer.render().copy()

    def close(self) -> None:
        """Give the memory back."""
        self._thread.submit(self._renderer.close).result()
        self._thread.shutdown()


def _at_exit(reference: weakref.ref) -> None:
    """Free what nobody has closed, before EGL itself ends: else it writes an error. The thread has gone by now."""
    if (pictures := reference()) is not None:
        pictures._renderer.close()
