#include "server/job_events.h"

#include "server/handlers.h"
#include "server/jobs.h"
#include "server/responses.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr const char* event_type = "text/event-stream";
/// Says that somebody is there; proxies close what is silent for long.
constexpr std::chrono::seconds heartbeat_time{10};
/// The id of the event that tells how a job ended: who has it needs no more.
constexpr const char* last_id = "ended";

}  // namespace

class JobFeed : public std::enable_shared_from_this<JobFeed> {
 public:
  JobFeed(JobFeeds& feeds, std::string id, std::shared_ptr<BodyWriter> body)
      : feeds_(feeds), id_(std::move(id)), body_(std::move(body)) {}

  void begin() {
    const std::weak_ptr<JobFeed> weak = weak_from_this();
    const auto soon = [&threads = feeds_.threads_, weak](void (JobFeed::*step)()) {
      threads.post([weak, step] {
        if (const auto feed = weak.lock()) (feed.get()->*step)();
      });
    };
    body_->when_abandoned([soon] { soon(&JobFeed::finish); });
    watch_ = std::make_unique<jobs::JobRunner::Watch>(feeds_.runner_, id_, [soon] { soon(&JobFeed::update); });
    update();
    beat_later();
  }

  /// Sends how the job is, unless the client has that already.
  void update() {
    const std::lock_guard lock(mutex_);
    if (over_) return;
    const auto status = feeds_.runner_.find(id_);
    const bool known = status && *status;
    const bool last = !known || has_ended(**status);
    if (known && (last || body_->has_room(nullptr))) {
      const std::string text = dump(to_json(**status, feeds_.base_path_));
      if (text != sent_)
        body_->add("event: job\nid: " + (last ? last_id : std::to_string(++count_)) + "\ndata: " + text + "\n\n");
      sent_ = text;
    }
    if (last || feeds_.runner_.is_stopped()) end();
  }

  void finish() {
    const std::lock_guard lock(mutex_);
    if (!over_) end();
  }

 private:
  void beat() {
    const std::lock_guard lock(mutex_);
    if (over_) return;
    if (body_->has_room(nullptr)) body_->add(": heartbeat\n\n");
    beat_later();
  }

  void beat_later() {
    const std::weak_ptr<JobFeed> weak = weak_from_this();
    heartbeat_ = feeds_.alarms_.at(jobs::Alarms::Clock::now() + heartbeat_time, [weak, &threads = feeds_.threads_] {
      threads.post([weak] {
        if (const auto feed = weak.lock()) feed->beat();
      });
    });
  }

  void end() {
    over_ = true;
    body_->finish();
    feeds_.let_go(shared_from_this());
  }

  JobFeeds& feeds_;
  const std::string id_;
  const std::shared_ptr<BodyWriter> body_;
  std::mutex mutex_;
  std::string sent_;
  std::uint64_t count_ = 0;
  bool over_ = false;
  std::unique_ptr<jobs::JobRunner::Watch> watch_;
  jobs::Alarms::Alarm heartbeat_;
};

JobFeeds::JobFeeds(jobs::JobRunner& runner, jobs::Alarms& alarms, AnswerThreads& threads, std::string base_path)
    : runner_(runner), alarms_(alarms), threads_(threads), base_path_(std::move(base_path)) {}
JobFeeds::~JobFeeds() = default;

std::shared_ptr<BodyReader> JobFeeds::follow(const std::string& id) {
  BodyStream stream = make_body_stream();
  const auto feed = std::make_shared<JobFeed>(*this, id, std::move(stream.writer));
  {
    const std::lock_guard lock(mutex_);
    feeds_.insert(feed);
  }
  feed->begin();
  return std::move(stream.reader);
}

void JobFeeds::let_go(const std::shared_ptr<JobFeed>& feed) {
  const std::lock_guard lock(mutex_);
  feeds_.erase(feed);
}

Operation describe_job_events() {
  return {.id = "followJob",
          .group = "Jobs",
          .title = "A job as it goes on",
          .doc =
              "Server-sent events: the job, as `GET /v1/jobs/{id}` tells it, at once and whenever it has changed, and "
              "a comment every ten seconds. The stream ends with the job; its last event has the id `ended`, and who "
              "connects again with that is answered 204, so that browsers do not connect for ever.",
          .parameters = {job_parameter(),
                         {.place = Parameter::Place::header,
                          .name = "Last-Event-ID",
                          .doc = "The id of the last event that came, as browsers send it when they connect again.",
                          .example = "3"}},
          .answers = {{.doc = "Events named `job`, whose data is a `Job`.",
                       .contents = {{.type = event_type}},
                       .headers = {"Cache-Control"}},
                      {.status = 204, .doc = "The client knows how the job ended."}},
          .problems = {"not-found", "storage-failed"}};
}

Reply job_events(const Context& context) {
  const auto status = job_of(context);
  if (!status) return problem_reply(status.problems(), context.exchange());
  if (context.request().header("Last-Event-ID") == last_id) return {.status = 204};
  return {.type = event_type,
          .stream = context.application.job_feeds.follow(context.arguments.front()),
          .headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}}};
}

}  // namespace dini::server
