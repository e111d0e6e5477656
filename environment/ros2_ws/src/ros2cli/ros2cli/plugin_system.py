"""The version of the plug-in interface, which upstream's extensions ask for."""

PLUGIN_SYSTEM_VERSION = '0.1'


class PluginException(Exception):
    """A plug-in asks for an interface that is not offered."""


def satisfies_version(version: str, caret_range: str) -> None:
    """
    Check a version against a range like `^0.1`: the same up to the first number that is not zero.

    :raises PluginException: if it does not fit.
    """
    wanted = caret_range.lstrip('^').split('.')
    given = version.split('.')
    significant = next((i for i, part in enumerate(wanted) if part != '0'), len(wanted) - 1) + 1
    if given[:significant] != wanted[:significant] or list(map(int, given)) < list(map(int, wanted)):
        raise PluginException(f'the plug-in interface is {version}, which is not {caret_range}')
