// SPDX-License-Identifier: Apache-2.0
// What every test includes, compiled once (cmake/SkeinLibrary.cmake).
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>
