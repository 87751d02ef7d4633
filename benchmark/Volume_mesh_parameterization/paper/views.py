"""From where the models are looked at: the direction to the viewer, and what is up."""

VIEWS = {"max": ((1, 0.6, 0.4), (0, 1, 0)),
         "sphinx": ((1, 0.3, 0.4), (0, 1, 0))}
DEFAULT = ((1, 0.7, 0.5), (0, 0, 1))


def view(case):
    return VIEWS.get(case.name.split("_")[0], DEFAULT)
