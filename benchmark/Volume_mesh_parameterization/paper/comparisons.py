"""The comparisons with other methods: Fig. 4, Fig. 5, Fig. 8 and Table 2."""
import printed_values as printed
from page import claims, figures, heading, paragraph, table
from render import RED, colored_surface, cut, image_of, inverted_cells, picture, read, surface
from runs import distortions
from views import view

D_COLUMNS = ["Daa", "Dma", "Dav", "Dmv"]


class Inverted_cells:
    """Fig. 4: energies without a barrier invert cells."""
    METHODS = (("dirichlet", "Dirichlet"), ("arap", "ARAP"), ("dirichlet_by_volume", "Dirichlet, weighted by volume"),
               ("arap_by_volume", "ARAP, weighted by volume"))

    def __init__(self, runs):
        self.case = runs.case("max", "polycube")
        self.jobs = {name: runs.baseline(name, self.case) for name, _ in self.METHODS}
        self.jobs["stretch"] = runs.ours(self.case, "stretch")

    def parts(self, output):
        direction, up = view(self.case)
        result = {name: job.result() for name, job in self.jobs.items()}
        inverted = {name: run.measures["inverted_cells"] for name, run in result.items()}
        pictures = [(picture(output / "figure_4_source.png",
                             [surface(cut(read(result["stretch"].vtu), (1, 0, 0)))], direction, up), "source, cut open")]
        for name in ("dirichlet", "arap", "stretch"):
            image = image_of(read(result[name].vtu))
            actors = [surface(cut(image, (1, 0, 0)))]
            if inverted[name] > 0:
                actors.append(surface(inverted_cells(image), RED))
            pictures.append((picture(output / f"figure_4_{name}.png", actors, direction, up),
                             f"{name}: {inverted[name]} inverted cells"))
        rows = [(f"paper, MaxPlanck, 23653 cells, {name}", n) for name, n in printed.FIGURE_4.items()]
        titles = dict(self.METHODS, stretch="stretch")
        cells = result["stretch"].measures["cells"]
        rows += [(f"ours, max, {cells} cells, {titles[name]}", n) for name, n in inverted.items()]
        return [heading("Fig. 4: inverted cells without a barrier"),
                claims([("Dirichlet and ARAP leave hundreds of inverted cells, stretch none",
                         min(inverted["dirichlet"], inverted["arap"]) >= 100 and inverted["stretch"] == 0,
                         ", ".join(f"{name} {inverted[name]}" for name in ("dirichlet", "arap", "stretch")))]),
                table(output / "figure_4.csv", ["", "inverted cells"], rows, range(len(printed.FIGURE_4))), figures(pictures)]


class Locally_injective:
    """Fig. 5: the boundary that locally injective mapping [8] reaches."""
    CASES = (("bone", "tet"), ("bone", "star"), ("bone", "octa"), ("bone", "pyr"), ("duck", "cube"), ("duck", "star"),
             ("max", "polycube"))
    PICTURES = 2

    def __init__(self, runs):
        self.cases = [runs.case(*names) for names in self.CASES]
        self.jobs = [(runs.baseline("injective", case), runs.ours(case, "stretch")) for case in self.cases]

    def parts(self, output):
        rows, pictures = [], []
        for i, (case, jobs) in enumerate(zip(self.cases, self.jobs)):
            results = [("ours", jobs[1].result()), ("[8]", jobs[0].result())]
            rows += [(f"{case.name}, {name}", run.measures["distance_max"], run.measures["distance_mean"],
                      run.measures["inverted_cells"], *distortions(run), run.steps, run.seconds) for name, run in results]
            if i < self.PICTURES:
                direction, up = view(case)
                pictures.append((picture(output / f"figure_5_{case.name}.png", [surface(read(results[0][1].vtu))],
                                         direction, up), f"{case.name}: source"))
                pictures += [(picture(output / f"figure_5_{case.name}_{key}.png",
                                      [surface(image_of(read(run.vtu)))], direction, up), f"{case.name}: {name}")
                             for key, (name, run) in zip(("ours", "injective"), results)]
        return [heading("Fig. 5: locally injective mapping [8]"),
                paragraph("Distances of the boundary to its target, relative to the diagonal of the target. [8] minimizes "
                          "the ARAP energy with its barrier, at most 200 steps, ours the stretch energy. As in the paper, "
                          "[8] does not meet boundaries that are hard to reach; it does meet others."),
                table(output / "figure_5.csv",
                      ["", "largest distance", "mean distance", "inverted cells", *D_COLUMNS, "steps", "seconds"], rows),
                figures(pictures, 340)]


class Bounded_distortion:
    """Fig. 8 and Table 2: bounded distortion mapping [7], and ours with the same bound."""
    CASES = (("max", "polycube", (64, 38, 20, 10)), ("duck", "cube", (64, 38)), ("sphinx", "octa", (64, 38)),
             ("sphinx", "cube", (64, 38)), ("hand", "polycube", (64, 20)))
    PICTURES = {"max_polycube": (38, 10), "sphinx_octa": (64, 38)}

    def __init__(self, runs):
        self.jobs = []
        for model, domain, bounds in self.CASES:
            case = runs.case(model, domain)
            if model == "hand":
                case = runs.refined(case)
            limit = ["--max-iterations", 300]
            free = runs.ours(case, "stretch", *limit)
            bounded = {K: (runs.ours(case, f"below_{K}", "--max-angle-distortion", K, "--volume-weights", *limit),
                           runs.baseline("bounded", case, K)) for K in bounds}
            self.jobs.append((case, free, bounded))

    def parts(self, output):
        rows, indices, verdicts, pictures = [], [], [], []
        for model, values in printed.TABLE_2.items():
            for row in values:
                indices.append(len(rows))
                rows.append((f"paper, {model}, {row.method}", *row.D, float(row.seconds), "", ""))
        for case, free, bounded in self.jobs:
            runs = [("ours, no bound", "ours", free.result())]
            for K, jobs in bounded.items():
                ours, theirs = (job.result() for job in jobs)
                runs += [(f"ours, K = {K}", f"ours_{K}", ours), (f"[7], K = {K}", f"bounded_{K}", theirs)]
                verdicts.append(self._verdict(case, K, ours, theirs))
            forced = runs[0][2].measures["unavoidable_angle"]
            rows += [(f"{case.name}, {name}", *distortions(run), run.seconds, run.measures["inverted_cells"], forced)
                     for name, _, run in runs]
            pictures += self._pictures(output, case, runs)
        return [heading("Table 2 and Fig. 8: bounded distortion mapping [7]"),
                paragraph("Ours with a bound is --max-angle-distortion K --volume-weights; [7] is stopped as soon as no "
                          "cell exceeds K, or after 1000 steps. Inverted cells are left out of the distortions. Bounds below "
                          "what the boundary forces are left out; so K = 10 is for max only. The hand is refined, so "
                          "that its boundary can be met at all, and its target, a cube, shrinks the fingers so much that its "
                          "distortions of volumes say little; it takes at most 300 steps a stage."),
                claims(verdicts),
                table(output / "table_2.csv",
                      ["", *D_COLUMNS, "seconds", "inverted cells", "Dma that the boundary forces"], rows, indices),
                *pictures]

    @staticmethod
    def _verdict(case, K, ours, theirs):
        names = ("Daa", "Dma", "Dav", "Dmv")
        worse = [f"{name} {a:.4g} > {b:.4g}"
                 for name, a, b in zip(names, distortions(ours), distortions(theirs)) if a > b]

        def reaches(run):
            is_below = distortions(run)[1] <= K + 1 / K and run.measures["inverted_cells"] == 0
            return "reaches the bound" if is_below else "misses the bound"
        return (f"{case.name}, K = {K}: ours has no higher Daa, Dma, Dav, Dmv than [7]", not worse,
                ", ".join([*worse, "ours " + reaches(ours), "[7] " + reaches(theirs)]))

    def _pictures(self, output, case, runs):
        if case.name not in self.PICTURES:
            return []
        direction, up = view(case)
        keys = ["ours"] + [f"{who}_{K}" for K in self.PICTURES[case.name] for who in ("ours", "bounded")]
        shown = [(name, key, run) for name, key, run in runs if key in keys]
        rows = []
        for array, title, i in (("angle_distortion", "angles", 1), ("volume_distortion", "volumes", 3)):
            # one scale for a row; [7] may have cells far beyond it
            largest = 2 * distortions(shown[0][2])[i]
            rows.append(figures([(picture(output / f"figure_8_{case.name}_{key}_{array}.png",
                                          [colored_surface(cut(read(run.vtu), (1, 0, 0)), array, largest)],
                                          direction, up, legend="log. scale"), f"{case.name}: {title}, {name}")
                                 for name, key, run in shown], 220))
        return rows
