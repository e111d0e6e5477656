"""The commands `ros2 doctor` and `ros2 wtf`, which are the same."""

from ros2cli.command import CommandExtension, add_subparsers_on_demand


class DoctorCommand(CommandExtension):
    """Check ROS setup and other potential issues."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        reports = parser.add_mutually_exclusive_group()
        reports.add_argument('--report', '-r', action='store_true', help='Print all reports instead of checking')
        reports.add_argument(
            '--report-failed', '-rf', action='store_true', help='Print the reports about the checks that failed'
        )
        parser.add_argument(
            '--exclude-packages', '-ep', action='store_true', help='Leave out the check and the report of packages'
        )
        parser.add_argument(
            '--include-warnings', '-iw', action='store_true', help='Let a check fail that has a warning'
        )
        add_subparsers_on_demand(parser, cli_name, '_verb', 'ros2doctor.verb', required=False)

    def main(self, *, parser, args):
        """Check, or report."""
        from ros2doctor.api import generate_reports, run_checks
        from ros2doctor.api.format import format_print

        verb = getattr(args, '_verb', None)
        if verb is not None:
            return verb.main(args=args)
        if args.report:
            for report in generate_reports(exclude_packages=args.exclude_packages):
                format_print(report)
            return 0
        categories, failed, total = run_checks(
            include_warnings=args.include_warnings, exclude_packages=args.exclude_packages
        )
        if failed:
            print(f'\n{failed}/{total} check(s) failed')
            print('\nFailed modules:', *sorted(categories))
        else:
            print(f'\nAll {total} checks passed\n')
        if args.report_failed and failed:
            for report in generate_reports(categories=categories):
                format_print(report)
        return 0


class WtfCommand(DoctorCommand):
    """Use `wtf` as alias to `doctor`."""
