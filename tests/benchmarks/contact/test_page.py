"""The page of the handbook that compares peers is written from the committed results."""

from benchmarks.contact import report


def test_the_page_is_that_of_the_results():
    assert report.PAGE.read_text("utf-8") == report.page()
