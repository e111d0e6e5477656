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

```{exercise} 7.1 twice as much
:points: 10
:names: double
```

```{code-cell} ipython3
def double(number):
    # BEGIN SOLUTION
    # STUB: return None
    return 2 * number
    # END SOLUTION
```

"""
CHECK_HERE = """```{code-cell} ipython3
:check: here
```

"""
OUTPUT = """```{code-cell} ipython3
:tags: [raises-exception]
print('before')
1 / 0
```
"""
TINY = FRONT + TITLE + DEMONSTRATION + EXERCISE + OUTPUT


def line_of(text: str, source: str = TINY) -> int:
    """Return the 1-based number of the first line that holds ``text``."""
    return next(number for number, line in enumerate(source.splitlines(), start=1) if text in line)
