"""Command lines in this process."""

from click.testing import CliRunner, Result

from hertzwerk.runtime.cli import main


def called(*words: object, code: int = 0) -> Result:
    """Call a command line and check its exit code."""
    done = CliRunner().invoke(main, list(map(str, words)), prog_name="hertzwerk", catch_exceptions=False)
    assert done.exit_code == code, done.output
    return done
