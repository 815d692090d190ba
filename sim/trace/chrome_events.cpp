#include "sim/trace/chrome_events.hpp"

#include "sim/report/seconds.hpp"

namespace maquette::sim {

ChromeEvents::ChromeEvents(const TraceWindow& window, std::ostream& stream) : text_(stream) {
  text_.add(R"({{"displayTimeUnit":"ns","otherData":{{"time":"simulated,)"
            R"( from the frame's start","window_from_s":"{}","window_to_s":"{}"}},)"
            R"("traceEvents":[)",
            format_seconds(window.from), format_seconds(window.to));
}

void ChromeEvents::name_process(int process, const std::string& name) {
  event(R"({{"ph":"M","name":"process_name","pid":{0},"args":{{"name":"{1}"}}}})", process, name);
  event(R"({{"ph":"M","name":"process_sort_index","pid":{0},)"
        R"("args":{{"sort_index":{0}}}}})",
        process);
}

void ChromeEvents::name_thread(const ChromeTrack& track, const std::string& name) {
  event(R"({{"ph":"M","name":"thread_name","pid":{},"tid":{},"args":{{"name":"{}"}}}})",
        track.process, track.thread, name);
  event(R"({{"ph":"M","name":"thread_sort_index","pid":{0},"tid":{1},)"
        R"("args":{{"sort_index":{1}}}}})",
        track.process, track.thread);
}

void ChromeEvents::slice(const ChromeTrack& track, const std::string& name, models::Instant from,
                         models::Instant to, const std::string& arguments) {
  event(R"({{"ph":"B","name":"{}","ts":{},"pid":{},"tid":{}{}}})", name, Microseconds(from).text(),
        track.process, track.thread, arguments);
  event(R"({{"ph":"E","ts":{},"pid":{},"tid":{}}})", Microseconds(to).text(), track.process,
        track.thread);
}

}  // namespace maquette::sim
