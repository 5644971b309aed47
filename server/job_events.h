#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "jobs/job_runner.h"
#include "server/answer_threads.h"
#include "server/body_stream.h"

namespace dini::server {

/// One client who follows a job: it is sent how the job is, at once and whenever that has changed, as server-sent
/// events. A client that is slow gets the newest only.
class JobFeed;

/// All who follow jobs.
class JobFeeds {
 public:
  /// Of a server below that path.
  JobFeeds(jobs::JobRunner& runner, jobs::Alarms& alarms, AnswerThreads& threads, std::string base_path);
  ~JobFeeds();

  /// The events of a job, until it has ended, the client leaves, or the server stops.
  std::shared_ptr<BodyReader> follow(const std::string& id);

 private:
  friend class JobFeed;
  void let_go(const std::shared_ptr<JobFeed>& feed);

  jobs::JobRunner& runner_;
  jobs::Alarms& alarms_;
  AnswerThreads& threads_;
  const std::string base_path_;
  std::mutex mutex_;
  std::set<std::shared_ptr<JobFeed>> feeds_;
};

}  // namespace dini::server
