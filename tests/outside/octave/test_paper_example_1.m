% The shares of failures are those of docs/development/paper.md: 17 %, 36 % and 63 % with eq9, none with consistent kernels.
failures = paper_example_1 (60) / 60;
assert (failures(1) < failures(2) && failures(2) < failures(3));
assert (abs (failures(1:3) - [0.17, 0.36, 0.63]) < 0.2);
assert (failures(4:5) == 0);
