"""From source to notebook: `solutions/NN_name.md` to the executed solution, the learner's notebook and exercises.json.

A source is a MyST Markdown notebook, read by jupytext. Prose is Markdown; ``+++`` on a line of its own splits it into
two cells. A code cell is a fence; its metadata stand in its first lines, each after a colon, each value YAML::

    ```{code-cell} ipython3
    :tags: [nbval-check-output]
    print(total)
    ```

An exercise is declared by a directive in the Markdown; its answer cell is the next code cell with a solution region::

    ```{exercise} 3.1 first talker
    :points: 10
    :names: Talker
    ```

    ```{code-cell} ipython3
    class Talker(Node):
        def __init__(self):
            super().__init__('talker')
            # BEGIN SOLUTION
            # STUB: self.publisher = None
            self.publisher = self.create_publisher(String, '/chatter', 10)
            # END SOLUTION
    ```

In the learner's notebook each region between BEGIN and END SOLUTION becomes ``# Your code here.`` followed by what its
STUB lines hold; in the solved notebook only the markers and STUB lines go. The
directive gives heading, first line and metadata of the answer cell, and the cell ``check("3.1")`` (see `cards`).

The tags are nbval's (``nbval-check-output``, ``nbval-ignore-output``, ``nbval-skip``) and ``raises-exception``. nbval
compares the output of every cell of the solved notebook that is not tagged ``nbval-ignore-output``. The learner's
notebook loses the nbval tags: it must run, its output is not compared.

Modules: `book` knows what chapters may refer to, `references` makes links of roles, `links` finds those that lead
nowhere, `glossary` reads the terms, `indexes` makes the pages for all chapters, `quizzes` the questions, `checked` runs
checked statements; `chapter` reads, `cards` reads the card of an exercise, `regions` splits an exercise, `rules` names
an author's mistakes, `notebooks` makes both notebooks, `execution` runs one, `outputs` says what is kept of outputs,
`build` writes all, `in_step` proves it, `repeated` makes the notebooks that CI gives to nbval.
"""
