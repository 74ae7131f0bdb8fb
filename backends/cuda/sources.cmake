# Sources of both builds of the plugin: RC_CUDA_SOURCES, and RC_CUDA_HAAR, those of haar-cg that need no other part of the library.
set(RC_CUDA_SOURCES arrays.cpp engine.cpp history.cpp lengths.cpp operator.cpp score.cpp session.cpp small/many.cpp small/spectrum.cpp solver.cpp tables.cpp trees.cpp)
list(TRANSFORM RC_CUDA_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/backends/cuda/)
rc_shared_sources(RC_CUDA_HAAR core/ranks.cpp core/text.cpp grid/downsample.cpp solvers/haar_cg/starts.cpp
  trees/tree_inputs.cpp trees/tree_shape.cpp)
