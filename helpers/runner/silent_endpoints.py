"""Event callbacks of endpoints that have none.

rclpy gives every publisher and subscription one for incompatible QoS profiles, and each is one more entity of the wait
set in every round: the tests' own endpoints do without.
"""

from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks

PUBLISHER = PublisherEventCallbacks(use_default_callbacks=False)
SUBSCRIPTION = SubscriptionEventCallbacks(use_default_callbacks=False)
