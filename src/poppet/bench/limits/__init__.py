"""What limits a valve, over load volume and amplitude."""
