// Many balls, planes and walls: scene, check, and first_events, which finds the earliest events.
#pragma once

#include <graze/scene/check_scene.hpp>
#include <graze/scene/first_events.hpp>
#include <graze/scene/overlapping.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_of.hpp>
