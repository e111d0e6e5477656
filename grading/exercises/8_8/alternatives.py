from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('asks_first', edits=(('self.buffer = Buffer()', 'self.tf = Buffer(node=self)'),
            ('self.listener = TransformListener(self.buffer, self)', 'self.tf_listener = TransformListener(self.tf, self)'),
            ('''
            try:
                found = self.buffer.lookup_transform('map', 'base_footprint', Time())
            except TransformException:
                return None
            if self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=0.5):
                return None
            place, turn = found.transform.translation, found.transform.rotation
            return place.x, place.y, math.remainder(2 * math.atan2(turn.z, turn.w), math.tau)
            ''', '''
            if not self.tf.can_transform('map', 'base_footprint', Time()):
                return None
            found = self.tf.lookup_transform('map', 'base_footprint', Time())
            stamp = found.header.stamp.sec + found.header.stamp.nanosec / 1e9
            if self.get_clock().now().nanoseconds / 1e9 - stamp > 0.5:
                return None
            turn = found.transform.rotation
            yaw = euler_from_quaternion((turn.x, turn.y, turn.z, turn.w))[2]
            return found.transform.translation.x, found.transform.translation.y, yaw
            ''')), imports='from tf_transformations import euler_from_quaternion'),
    Alternative('seconds_in_floats', edits=(('''
            if self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=0.5):
                return None
            ''', '''
            stamp, now = found.header.stamp, self.get_clock().now().nanoseconds * 1e-9
            if now - (stamp.sec + stamp.nanosec * 1e-9) > 0.5:
                return None
            '''),)),
]
