#include "workflow/convert.hpp"

namespace fogcomp::workflow {

recording::Recording convert(const ConvertRequest& request, const Observer& observer) {
  recording::ReadOptions reading = observer.with_observer(request.reading);
  reading.keep_refused_rows = true;
  reading.every_row = true;
  return recording::read_recording(request.run, reading);
}

}  // namespace fogcomp::workflow
