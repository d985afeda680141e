#pragma once

#include <string>

#include "client/cli/command.h"

namespace celt::cli {

/// `celt jobs <verb> ID`.
class JobCommand : public Command {
 public:
  CLI::App* AddTo(CLI::App& parent) final;

 protected:
  const std::string& id() const { return id_; }

 private:
  virtual std::string Verb() const = 0;
  virtual std::string Description() const = 0;
  virtual void AddOptions(CLI::App& /*app*/) {}

  std::string id_;
};

}  // namespace celt::cli
