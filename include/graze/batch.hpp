// Many pairs at once: batch::classify, batch::overlaps and batch::time_of_impact, exactly.
#pragma once

#include <graze/predicate/batch.hpp>
#include <graze/time/batch.hpp>
