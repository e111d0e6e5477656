"""Calls of services by actions: they wait for the service and for the answer while the launch goes on."""

from __future__ import annotations

import asyncio
from logging import Logger
from typing import Any

from launch.launch_context import LaunchContext

_LOOK_AGAIN = 0.05  # seconds between two looks whether a service is there: no one tells of it


async def call_service(
    context: LaunchContext, client: Any, request: Any, logger: Logger, timeout: float | None = None
) -> Any:
    """
    Return the answer of a service; None after the timeout, or if the system shuts down, which the log says.

    :param client: a client of the launch's node
    :param timeout: seconds for the answer, once the service is there
    """
    while not client.service_is_ready():
        if _given_up(context, logger, f"Abandoning wait for the '{client.srv_name}' service, due to shutdown."):
            return None
        await asyncio.sleep(_LOOK_AGAIN)
    answered = asyncio.Event()
    future = client.call_async(request)
    future.add_done_callback(lambda _: context.asyncio_loop.call_soon_threadsafe(answered.set))
    waited = 0.0
    while not future.done():
        if _given_up(
            context, logger, f"Abandoning wait for the '{client.srv_name}' service response, due to shutdown."
        ) or (timeout is not None and waited >= timeout):
            client.remove_pending_request(future)
            return None
        try:
            await asyncio.wait_for(answered.wait(), _LOOK_AGAIN)
        except asyncio.TimeoutError:
            waited += _LOOK_AGAIN
    return future.result()


def _given_up(context: LaunchContext, logger: Logger, message: str) -> bool:
    if context.is_shutdown:
        logger.warning(message)
    return context.is_shutdown
