"""Residuals of pressures by an independent checker, for the certificate tests.

usage: verify.py VERIFY_KKT.py JOBS.json RESULTS.json
A job holds compenetrations u and forces p (n1 rows of n2 values), kernel, delta, Es and spacing; a result neg_p, neg_w, w_contact and
compl, the last as the library defines it: the largest of min(p / max p, |w| / max u). Exits with 77 where NumPy is missing.
"""
import importlib.util
import json
import sys

try:
    import numpy as np
except ImportError:
    sys.exit(77)

sys.dont_write_bytecode = True


def main(checker_file, jobs_file, results_file):
    spec = importlib.util.spec_from_file_location("checker", checker_file)
    checker = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(checker)

    with open(jobs_file) as file:
        jobs = json.load(file)
    results = []
    for job in jobs:
        shape = (job["n1"], job["n2"])
        u, p = np.array(job["u"]).reshape(shape), np.array(job["p"]).reshape(shape)
        model = (job["kernel"], job["delta"], job["Es"], job["spacing"])
        result = checker.residuals(u, p, *model)
        w = checker.matvec(np.maximum(p, 0), *model) - u
        scale = max(p.max(), 1e-300), max(u.max(), 1e-300)
        contact = p > 0
        result["compl"] = float(np.minimum(p / scale[0], np.abs(w) / scale[1])[contact].max()) if contact.any() else 0.0
        results.append(result)
    with open(results_file, "w") as file:
        json.dump(results, file)


main(*sys.argv[1:])
