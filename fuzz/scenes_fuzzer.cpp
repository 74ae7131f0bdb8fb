// One step of one system. An independent oracle checks the library's answer.
#include "oracle.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  fuzz::Scene scene;
  fuzz::read_scene(bytes, scene);
  fuzz::Step step;
  fuzz::read_step(bytes, scene, {}, false, step);
  rc_options* const options = fuzz::make_options(scene);
  fuzz::Answer answer(scene.points());
  answer.took(rc_solve(&scene.system, &step.given, options, &answer.result));
  scene.fails_at = 0;
  fuzz::Oracle(scene).check({step.undeformed_gap.data(), fuzz::mask_of(step.given), step.given.control, step.given.target},
                            answer);
  double most = 0;
  if (answer.status >= 0 && rc_options_get_number(options, RC_OPT_MAX_ITER, &most) == RC_OK)
    fuzz::require(static_cast<double>(answer.result.iterations) <= most, "no more iterations than max_iter");
  rc_options_destroy(options);
  return 0;
}
