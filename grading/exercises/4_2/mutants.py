from grading.variants import Mutant

FINE = "'focal length': 0 < k[0] < inf and 0 < k[4] < inf,"
POINT = "'principal point': 0 <= k[2] <= info.width and 0 <= k[5] <= info.height,"
WORDS = 'test_words'
PUBLISHED = 'test_published'

MUTANTS = [
    Mutant('no_nan_in_d', breaks='distortion', old='len(info.d) == 5',
           new='len(info.d) == 5 and all(number == number for number in info.d)',
           expect='The five numbers themselves are not checked'),
    Mutant('another_known_model', breaks='distortion', also=('order', 'unchanged'), old="info.distortion_model == 'plumb_bob'",
           new="info.distortion_model in ('plumb_bob', 'rational_polynomial')",
           expect="distortion_model = 'rational_polynomial' was accepted"),
    Mutant('signed_size', breaks='size', also='accept', old="'size': info.width > 0", new="'size': 0 < info.width < 2**31",
           expect="was refused with 'size'"),
    Mutant('trusts_the_next_one', breaks='distortion', also=('unchanged', 'order'),
           old='response.success = not response.status_message', new='''
           response.success = not response.status_message or (
               response.status_message == 'distortion' and getattr(self, 'calibrated', False))
           self.calibrated = response.success
           ''', expect='was accepted'),
    Mutant('one_direction_first', breaks='order', old="next((word for word in fine if not fine[word]), '')",
           new="('principal point' if fine['size'] and 0 < k[0] < inf and not 0 <= k[2] <= info.width else '') or "
               "next((word for word in fine if not fine[word]), '')", expect='the first one of the list decides'),
    Mutant('finite_distortion', breaks='distortion', old='len(info.d) == 5',
           new='len(info.d) == 5 and all(abs(number) < inf for number in info.d)',
           expect='The five numbers themselves are not checked'),
    Mutant('absolute_service', breaks='names', also=('always', 'publish'), old="'set_camera_info'",
           new="'/set_camera_info'", expect='without a leading slash'),
    Mutant('absolute_topic', breaks='names', old="'camera_info', latched", new="'/camera_info', latched",
           expect='without a leading slash'),
    Mutant('another_focal_length', breaks='focal-length', also=('order', 'nan'), old='and 0 < k[4] < inf', new='',
           expect='k[4] = 0.0 was accepted'),
    Mutant('answers_ok', breaks='accept', also=('principal-point', 'names'),
           old='response.success = not response.status_message', new='''
        response.success = not response.status_message
        response.status_message = response.status_message or 'ok'
        ''', expect="got the message 'ok'"),
    Mutant('any_distortion', breaks='distortion', also='unchanged',
           old="info.distortion_model == 'plumb_bob' and len(info.d) == 5", new="info.distortion_model == 'plumb_bob'",
           expect='len(d) = 0 was accepted'),
    Mutant('any_model', breaks='distortion', old="info.distortion_model == 'plumb_bob' and len(info.d) == 5",
           new='len(info.d) == 5', expect="distortion_model = 'equidi"),
    Mutant('at_least_five', breaks='distortion', old='len(info.d) == 5', new='len(info.d) in (4, 5, 8)',
           expect='len(d) = 4 was accepted'),
    Mutant('copies_some_fields', breaks='publish', old='self.publisher.publish(info)',
           new='self.publisher.publish(CameraInfo(width=info.width, height=info.height, k=info.k, d=info.d, '
               'distortion_model=info.distortion_model, header=info.header))', expect='not the calibration as it came'),
    Mutant('copies_all_but_r', breaks='publish', old='self.publisher.publish(info)', new='''
        copy = CameraInfo()
        for name in info.get_fields_and_field_types():
            setattr(copy, name, getattr(copy if name == 'r' else info, name))
        self.publisher.publish(copy)
        ''', expect='not the calibration as it came: r differs'),
    Mutant('whole_seconds', breaks='publish', old='self.publisher.publish(info)', new='''
        info.header.stamp.nanosec = 0
        self.publisher.publish(info)
        ''', expect='not the calibration as it came: header differs'),
    Mutant('depth_10', breaks='latched', old='QoSProfile(depth=1,', new='QoSProfile(depth=10,', expect='use depth 1'),
    Mutant('fixed_size', breaks='principal-point', old=POINT,
           new="'principal point': 0 <= k[2] <= 640 and 0 <= k[5] <= 480,", also=('accept', 'nan', 'publish'),
           expect='breaks no rule and was refused'),
    Mutant('infinite_focal_length', breaks='focal-length', old='< inf and 0 < k[4] < inf', new='and 0 < k[4]',
           expect='A focal length must be finite'),
    Mutant('joins_words', breaks='order', old="next((word for word in fine if not fine[word]), '')",
           new="', '.join(word for word in fine if not fine[word])", expect='the first one of the list decides'),
    Mutant('last_broken_rule', breaks='order', old='in fine if', new='in reversed(fine) if',
           expect='Several rules are broken: the first one'),
    Mutant('nan_passes', breaks='nan', old=FINE,
           new="'focal length': not (k[0] <= 0 or k[4] <= 0 or inf in (k[0], k[4])),",
           expect='Every comparison with nan is false'),
    Mutant('nan_point_passes', breaks='nan', old=POINT, new="'principal point': not (k[2] < 0 or k[2] > info.width or "
           'k[5] < 0 or k[5] > info.height),', expect='Every comparison with nan is false'),
    Mutant('no_return', breaks='always', also=('publish', 'unchanged', 'order', 'nan'), old='''
        if response.success:
            self.publisher.publish(info)
        return response
        ''', new='''
        if response.success:
            self.publisher.publish(info)
            return response
        ''', expect='the callback of the service returned nothing (None)'),
    Mutant('no_width', breaks='size', also=('order', 'principal-point'), old='info.width > 0 and info.height > 0',
           new='info.height > 0', expect='width = 0, k[2] = 0.0 was accepted'),
    Mutant('other_name', breaks='names', old="super().__init__('camera')", new="super().__init__('camera_driver')",
           expect='your node is called'),
    Mutant('publishes_always', breaks='unchanged', old='''
        if response.success:
            self.publisher.publish(info)
        ''', new='self.publisher.publish(info)', expect='a calibration that is refused is not published'),
    Mutant('publishes_first_only', breaks='publish', also=('latched', 'unchanged'), old='if response.success:', new='''
        if response.success and not hasattr(self, 'info'):
            self.info = info
        ''', expect='not the calibration as it came'),
    Mutant('publishes_twice', breaks='publish', old='self.publisher.publish(info)', new='''
        self.publisher.publish(info)
        self.publisher.publish(info)
        ''', also=('unchanged', 'names'), expect='good calibrations were published 2 times'),
    Mutant('raises', breaks='always', also=('publish', 'order', 'nan', 'unchanged'),
           old='response.success = not response.status_message', new='''
        response.success = not response.status_message
        if response.status_message:
            raise ValueError(response.status_message)
        ''', expect='raised ValueError'),
    Mutant('repeats_the_last', breaks='unchanged', old='if response.success:', new='''
        self.good = info if response.success else getattr(self, 'good', None)
        if self.good:
            info = self.good
        ''', expect='a calibration that is refused is not published'),
    Mutant('size_above_one', breaks='size', old='info.width > 0 and info.height > 0',
           new='info.width > 1 and info.height > 1', expect='A width and a height of 1 are allowed'),
    Mutant('strict_limits', breaks='principal-point', old=POINT,
           new="'principal point': 0 < k[2] < info.width and 0 < k[5] < info.height,", expect='The limits are allowed'),
    Mutant('swapped_limits', breaks='principal-point', also=('accept', 'publish', 'nan', 'size'), old=POINT,
           new="'principal point': 0 <= k[2] <= info.height and 0 <= k[5] <= info.width,",
           expect='breaks no rule and was refused'),
    Mutant('volatile', breaks='latched', also=('publish', 'unchanged', 'names', 'always'),
           old='latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)',
           new='latched = QoSProfile(depth=1)', expect='TRANSIENT_LOCAL'),
    Mutant('only_new_ones', old='if response.success:', new='''
        known, self.known = getattr(self, 'known', None), info if response.success else None
        if response.success and info != known:
        ''', expect='published', breaks='publish'),
    Mutant('zeros_are_nothing', breaks='distortion', old='len(info.d) == 5', new='len(info.d) == 5 and any(info.d)',
           expect='Five zeros are five numbers'),
    Mutant('fills_an_empty_header', old='self.publisher.publish(info)', new='''
        info.header.frame_id = info.header.frame_id or 'camera'
        self.publisher.publish(info)
        ''', expect='as it came', breaks='publish'),
    Mutant('limited_size', old="'size': info.width > 0 and info.height > 0,",
           new="'size': 0 < info.width < 10000 and 0 < info.height < 10000,", expect='breaks no rule', breaks='size'),
    Mutant('their_product', breaks='focal-length', old="0 < k[0] < inf and 0 < k[4] < inf", new='0 < k[0] * k[4] < inf',
           also=('nan', 'order'), expect='was accepted'),
    Mutant('not_too_large', breaks='focal-length', old="0 < k[0] < inf and 0 < k[4] < inf",
           new='0 < k[0] < 1e6 and 0 < k[4] < 1e6', expect='A focal length has no upper limit'),
    Mutant('any_case', breaks='distortion', old='info.distortion_model ==', new='info.distortion_model.lower().strip() ==',
           expect="distortion_model = '"),
    Mutant('begins_like_it', breaks='distortion', old="info.distortion_model == 'plumb_bob'",
           new="info.distortion_model.startswith('plumb_bob')", expect="distortion_model = 'plumb_b"),
    Mutant('short_life', breaks='latched', old='depth=1, durability', new='depth=1, lifespan=Duration(seconds=10), durability',
           imports='from rclpy.duration import Duration', expect='has the lifespan 10 s'),
    Mutant('an_empty_one_first', breaks='publish', old="self.create_service(SetCameraInfo, 'set_camera_info', self.on_set)",
           new="""
        self.create_service(SetCameraInfo, 'set_camera_info', self.on_set)
        self.publisher.publish(CameraInfo())
        """, also=('unchanged', 'names', 'latched'), expect='before a calibration was set'),
    Mutant('checks_all_of_k', breaks='focal-length', also='publish',
           old='0 < k[0] < inf and 0 < k[4] < inf', new='0 < k[0] < inf and 0 < k[4] < inf and k[8] == 1',
           expect='the other places of k are not checked'),
    Mutant('checks_that_k_is_finite', breaks='focal-length', old='0 < k[0] < inf and 0 < k[4] < inf',
           new='0 < k[0] < inf and 0 < k[4] < inf and all(abs(k[n]) < inf for n in (1, 3, 6, 7, 8))',
           expect='and no other place of k'),
    Mutant('checks_the_distortion', breaks='distortion', old='len(info.d) == 5',
           new='len(info.d) == 5 and all(abs(one) < 10 for one in info.d)', expect='The five numbers themselves'),
    Mutant('landscape_only', breaks='size', also=('principal-point',), old='info.width > 0 and info.height > 0',
           new='0 < info.height <= info.width', expect='higher than it is wide'),
    Mutant('region_inside_of_the_image', breaks='size', also='publish', old='info.width > 0 and info.height > 0',
           new='info.width > 0 and info.height > 0 and info.roi.x_offset + info.roi.width <= info.width',
           expect='Header, binning, roi'),
    Mutant('publisher_in_the_class', old='self.publisher = ', new='Camera.publisher = ', breaks='publish',
           expect='came on /other/camera_info'),
    Mutant('limits_with_a_tolerance', breaks='principal-point', old='0 <= k[2] <= info.width', new='-1e-6 <= k[2] <= info.width + 1e-6',
           expect='without rounding'),
    Mutant('point_in_whole_pixels', breaks='principal-point', also='nan', old='0 <= k[5] <= info.height',
           new='abs(k[5]) < inf and 0 <= int(k[5]) <= info.height', expect='[5] ='),
    Mutant('only_for_those_who_listen', old='if response.success:',
           new='if response.success and self.publisher.get_subscription_count():',
           expect='accepted while nobody listened', breaks='latched'),
]
