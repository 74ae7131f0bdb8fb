"""Options as keywords with their defaults, for help().

Written by scripts/bindings.py.
"""

OPTIONS = """
        solver='auto': solver by name; auto: the one that needs least time, by its own estimate
        backend='auto': backend by name, or a preference list "a,b"; auto: the one that needs least time, by its own
            estimate
        kernel='auto': influence kernel by name; auto is love for free and spectral for periodic boundaries (fixed)
        tol=1e-8 (1e-16 .. 0.1): largest relative residual of a certified answer
        max_iter=10000 (1 .. 1e+09): iterations of the solver after which it stops
        time_limit=0 (0 .. 1e+09): seconds after which a step stops; 0: no limit
        threads=every core that pays (1 .. 1024): threads that a contact may use, or a batch of contacts (fixed)
        deterministic=1 (0 .. 1): 1: the same bits in every run and for every number of threads; 0: components may
            trade them for speed (fixed)
        stiffness=0 (0 .. 2): 1: compute dW/dd of the contact set, one more linear solve; 2: prove an interval of it,
            up to two more
        allow_fallback=1 (0 .. 1): 1: the core may replace an operation that a backend lacks by a slower one, named in
            the result
        warmup='none': solver that runs first, for warmup.iterations; none: no warm-up
        warmup_iterations=50 (1 .. 1e+09): iterations of the warm-up
        resumable=0 (0 .. 1): 1: a step depends on the last two certified ones alone, so that rc_contact_restore
            continues with the same bits; factors and other leftovers of earlier steps are made anew
        bounds=1 (0 .. 1): 1: prove intervals for load and contact area from the duality gap
        accuracy=0 (0 .. 0.5): relative error that load or area may have: a coarser grid is solved where that will do,
            to a hundredth of it at most; 0: the given grid to tol (fixed)
        accuracy_of='load' (load, area): what accuracy is of; in load control, load: the load that belongs to the
            approach found (fixed)
        certify_backend='': backend for the certificate's product; empty: the solving one
        admm_relaxation=1.7 (1 .. 1.95): over-relaxation; 1: none
        admm_rho=0 (0 .. 1e+12): penalty, relative to the contact modulus and the cell size; 0: from the eigenvalues
            of H
        cmr_inner='auto': solver on every level, by name
        cmr_levels=0 (0 .. 30): grids of the cascade, the given one included; 0: down to 16 points a side
        cmr_radius=2 (1 .. 1000): h: radius of the area of influence in coarse cells
        cmr_area='diagonal' (diagonal, side): the radius is h times the diagonal (the paper's text) or the side (its
            Algorithm 6)
        cmr_filter='max' (subsample, mean, max): what a coarse point takes from its four heights: one, their mean or
            the highest
        cmr_certified=1 (0 .. 1): 1: add points that overlap and solve again until none does; 0: as published, may be
            wrong
        cmr_select='influence' (influence, gap): what is kept of the given grid: points within the area of influence,
            or tiles that the coarser pressure leaves nearly closed
        gp_lipschitz='collatz' (collatz, frobenius): step length from a tight bound of the largest eigenvalue
            (collatz) or from the Frobenius norm, as published, where the backend has it
        gp_restart=1 (0 .. 1): 1: the acceleration starts afresh where it points uphill; 0: never, as published
        greedy_inner='cg' (cg, gauss-seidel, cholesky): how each set is solved; gauss-seidel stores the matrix, of at
            most 4096 candidates
        greedy_repair=0 (0 .. 1): 1: where dropped points overlap, nnls goes on from the contact set found
        haar_cg_products='mixed' (mixed, double): mixed: single precision, corrected by some in double precision
        haar_cg_nested=1 (0 .. 1): 1: without a start, begin on coarser grids
        haar_cg_patience=120 (0 .. 1e+06): bounded steps without half the residual before the exact fallback takes
            over
        haar_cg_inverse=600 (0 .. 4096): most points in contact for which steps near each other keep the inverse of H
            there, 4 bytes a pair
        nnls_pivoting='block' (block, single): block: all infeasible points at once, a handful of solves; single: one
            point a solve, as published
        cholmod_memory_limit=8192 (1 .. 1e+09): most memory for a factor while it is made [MiB] (fixed)
        cholmod_near_field=0 (0 .. 1e+06): 0: factor all entries; else: iterate, and factor those up to so many cells
            apart (fixed)
        dense_memory_limit=8192 (1 .. 1e+09): most memory for matrix and factors together [MiB] (fixed)
        fft_precision='auto' (auto, mixed, single): single: half the memory, every product off by up to 5e-7 of its
            largest entry; for tol of 1e-5 and above only. auto: single where option accuracy allows it, else mixed
            (fixed)
        split_spacing='auto' (auto, 4, 8, 16): cells of the grid to a cell of the coarse one; auto: what costs least
            (fixed)
"""
