#pragma once

/// The template core of osculo: scene types, engines and everything below them.
#include "osculo/engine/engine.hpp"
#include "osculo/engine/scenes.hpp"
