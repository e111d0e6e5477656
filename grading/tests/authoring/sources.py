"""A tiny chapter, and the same with mistakes."""

FRONT = """---
jupytext:
  text_representation:
    extension: .md
    format_name: myst
kernelspec:
  name: python3
  display_name: Python 3 (ipykernel)
  language: python
---

"""
TITLE = '# 7 Tiny\n\n'
DEMONSTRATION = """```{code-cell} ipython3
def check(identifier):
    print('checked', identifier)
```

"""
EXERCISE = """Some prose.

```{code-cell} ipython3
:exercise: {"id": "7.1", "points": 10, "names": ["double"]}
# Exercise 7.1: twice as much
def double(number):
    # BEGIN SOLUTION
    # STUB: return None
    return 2 * number
    # END SOLUTION
```

"""
CHECK = """```{code-cell} ipython3
check("7.1")
```

"""
OUTPUT = """```{code-cell} ipython3
:tags: [raises-exception]
print('before')
1 / 0
```
"""
TINY = FRONT + TITLE + DEMONSTRATION + EXERCISE + CHECK + OUTPUT


def line_of(text: str, source: str = TINY) -> int:
    """Return the 1-based number of the first line that holds ``text``."""
    return next(number for number, line in enumerate(source.splitlines(), start=1) if text in line)
