"""What Jin et al., Stretch-Minimizing Volumetric Parameterization (JCST 30(3), 2015), print.

D is (Daa, Dma, Dav, Dmv): the mean and the maximal distortion of angles, then of volumes."""
from collections import namedtuple

Row = namedtuple("Row", "method D seconds")

# Table 1: the duck (2464 vertices, 12601 cells) to a cube
TABLE_1 = {
    "dirichlet": Row("Dirichlet", (3.2, 273.7, 5.2, 34.7), 1047),
    "arap": Row("ARAP", (2.9, 254.9, 5.1, 33.7), 1041),
    "stretch": Row("Stretch", (2.8, 12.3, 5.1, 34.7), 1098),
    "lscm": Row("LSCM", (6.7, 652.1, 5.3, 31.6), 1018),
    "lpm": Row("LPM", (3.9, 236.0, 5.3, 30.1), 1569)}

# Table 2: the hand (8366 vertices, 40627 cells) and the sphinx (10528 vertices, 43371 cells) to polycubes
TABLE_2 = {
    "hand": [Row("stretch", (3.8, 63.9, 4.6, 41.3), 684),
             Row("[7], K = 64", (4.0, 63.8, 4.8, 559.8), 943),
             Row("[7], K = 20", (3.9, 20.0, 4.7, 91.4), 425)],
    "sphinx": [Row("stretch", (2.6, 38.4, 2.1, 68.2), 110),
               Row("[7], K = 38", (2.8, 37.9, 2.4, 258.0), 499),
               Row("[7], K = 10", (2.6, 10.0, 2.3, 102.2), 588)]}

# Fig. 2: the cow (5876 vertices, 19232 cells), weight 1e4, with and without relaxation
FIGURE_2 = {"with": {"steps": 46, "seconds": 272}, "without": {"steps": 500, "seconds": 1597}}

# Fig. 4: inverted cells of MaxPlanck (23653 cells) to a polycube
FIGURE_4 = {"dirichlet": 921, "arap": 1114, "stretch": 0}

# Fig. 6 and 7: steps for the duck, read off the axes of the plots
FIGURES_6_7 = {"dirichlet": 18, "arap": 12, "stretch": 14, "lscm": 70, "lpm": 25}
