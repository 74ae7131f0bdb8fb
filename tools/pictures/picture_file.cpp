#include "pictures/picture_file.h"

#include "files/outputs.h"
#include "platform/files.h"
#include "text.h"

namespace cli {

void write_picture(const std::string& path, const std::function<Gnuplot(std::FILE*)>& draw) {
  write_output(rc_platform::path_of(path), [&](std::FILE* file) {
    const Gnuplot outcome = draw(file);
    if (outcome.missing) {
      report("gnuplot not found: " + path + " not drawn");
    } else if (!outcome.drawn) {
      report(path + " not drawn, gnuplot failed: " + outcome.message);
    }
    return outcome.drawn;
  });
}

}  // namespace cli
