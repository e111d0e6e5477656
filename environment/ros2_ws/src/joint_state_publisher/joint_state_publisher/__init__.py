"""The node `joint_state_publisher` (see `joint_state_publisher.node`)."""
