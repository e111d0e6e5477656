"""Network interfaces: is there one that DDS can use, and does it do multicast."""

import socket

import psutil

from ros2doctor.api import DoctorCheck, DoctorReport, Report, Result
from ros2doctor.api.format import doctor_error, doctor_warn

_NO_ADDRESS = '00:00:00:00:00:00'


class NetworkCheck(DoctorCheck):
    """Look for a loopback interface, another one, and multicast."""

    def category(self):
        """Return the category."""
        return 'network'

    def check(self):
        """Check the flags of the interfaces that have an address."""
        result = Result()
        stats = psutil.net_if_stats()
        flags = [stats[name].flags.lower().split(',') for name in psutil.net_if_addrs() if name in stats]
        if not any('loopback' in each for each in flags):
            doctor_error('No loopback IP address is found.')
            result.add_error()
        if all('loopback' in each for each in flags):
            doctor_warn('Only loopback IP address is found.')
            result.add_warning()
        if not any('multicast' in each for each in flags):
            doctor_warn('No multicast IP address is found.')
            result.add_warning()
        return result


class NetworkReport(DoctorReport):
    """Report addresses and flags of each interface."""

    def category(self):
        """Return the category."""
        return 'network'

    def report(self):
        """Collect what psutil knows."""
        report = Report('NETWORK CONFIGURATION')
        stats = psutil.net_if_stats()
        for name, addresses in psutil.net_if_addrs().items():
            v4 = [each for each in addresses if each.family == socket.AF_INET]
            facts = {
                'inet': v4[-1].address if v4 else None,
                'inet4': [each.address for each in v4],
                'ether': next(
                    (
                        each.address
                        for each in addresses
                        if each.family == psutil.AF_LINK and each.address != _NO_ADDRESS
                    ),
                    None,
                ),
                'inet6': [each.address for each in addresses if each.family == socket.AF_INET6],
                'netmask': v4[-1].netmask if v4 else None,
                'device': name,
                'flags': f'<{stats[name].flags.upper()}>' if name in stats else None,
                'mtu': stats[name].mtu if name in stats else None,
                'broadcast': v4[-1].broadcast if v4 else None,
            }
            for key, value in facts.items():
                if value:
                    report.add_to_report(key, value)
        return report
