"""The node `robot_state_publisher` (see `robot_state_publisher.node`)."""
