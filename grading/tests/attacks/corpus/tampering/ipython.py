# attack: changes how notebooks are executed
# row: 7
# aims at: 90.1
# stopped by: no notebook is executed; the cells are read
# expect verdict: invalid_submission or learner_crashed or failed
# expect message: 90.1 or wrong or NameError
get_ipython().ast_transformers.append(None)


def total(numbers):
    return 0
