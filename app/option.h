#pragma once

#include "renderer/result.h"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>

namespace asos {

/// Adds an option whose text `parse` reads into `assign`, so that every refusal is a usage error
/// in our own words. `shape` is what the help shows in the value's place.
template <typename Parse, typename Assign>
CLI::Option* add_parsed_option(CLI::App& app, const std::string& name, const std::string& shape,
                               const std::string& help, Parse parse, Assign assign) {
  return app
      .add_option_function<std::string>(
          name,
          [name, parse, assign](const std::string& text) {
            auto value = parse(text);
            if (!value) throw CLI::ValidationError(name, value.error().message());
            assign(*std::move(value));
          },
          help)
      ->type_name(shape);
}

}  // namespace asos
