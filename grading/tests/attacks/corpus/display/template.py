# attack: writes templates, mark-up and formulas instead of names
# row: 37
# aims at: 90.1
# stopped by: a learner's text is data, never a template
# expect verdict: learner_crashed
# expect message: 7*7
def total(numbers):
    raise ValueError('{{ 7*7 }} {% for x in y %} ${7*7} [red]x[/red] [link=x]y[/link] =HYPERLINK("x") %s %(name)s {0}')
